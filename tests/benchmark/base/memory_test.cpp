// SPDX-License-Identifier: MIT
#include "benchmark/base/memory.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

TEST(Memory, SomeIsFree) {
  ASSERT_TRUE(FreeMemory());
  EXPECT_GT(*FreeMemory(), 1e6);
  EXPECT_LT(*FreeMemory(), 1e15);
}

TEST(Memory, WhatDoesNotFitIsToldWithItsSize) {
  EXPECT_NO_THROW(RequireMemory(1e3, "a letter", "write less"));
  try {
    RequireMemory(1e18, "a rollout", "take fewer lanes");
    FAIL();
  } catch (const sim::Error& error) {
    EXPECT_THAT(error.what(),
                testing::MatchesRegex("a rollout takes 1000000000.0 GB of memory, but .* GB are "
                                      "free; take fewer lanes"));
  }
}

}  // namespace
}  // namespace bulletnav::bench
