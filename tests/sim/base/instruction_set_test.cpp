// SPDX-License-Identifier: MIT
#include "sim/base/instruction_set.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

class InstructionSetTest : public testing::Test {
 protected:
  void TearDown() override { unsetenv("BULLETNAV_ISA"); }
  static void Allow(const char* name) { setenv("BULLETNAV_ISA", name, 1); }
};

TEST_F(InstructionSetTest, TheVariableNarrowsAndNeverWidens) {
  unsetenv("BULLETNAV_ISA");
  const bool has_avx2 = MayUse(InstructionSet::kAvx2);
  const bool has_amx = MayUse(InstructionSet::kAmx);
  const bool has_avx512 = MayUse(InstructionSet::kAvx512);
  const bool has_sse41 = MayUse(InstructionSet::kSse41);
  Allow("avx512");
  EXPECT_EQ(MayUse(InstructionSet::kAvx512), has_avx512);
  EXPECT_EQ(MayUse(InstructionSet::kAvx2), has_avx2);
  EXPECT_FALSE(MayUse(InstructionSet::kAmx));
  Allow("amx");
  EXPECT_EQ(MayUse(InstructionSet::kAmx), has_amx);
  Allow("avx2");
  EXPECT_FALSE(MayUse(InstructionSet::kAmx));
  EXPECT_FALSE(MayUse(InstructionSet::kAvx512));
  EXPECT_EQ(MayUse(InstructionSet::kAvx2), has_avx2);
  Allow("sse41");
  EXPECT_FALSE(MayUse(InstructionSet::kAvx512));
  EXPECT_FALSE(MayUse(InstructionSet::kAvx2));
  EXPECT_EQ(MayUse(InstructionSet::kSse41), has_sse41);
}

TEST_F(InstructionSetTest, OtherNamesAreRefused) {
  for (const char* name : {"", "AVX2", "neon"}) {
    Allow(name);
    EXPECT_THROW(MayUse(InstructionSet::kAvx2), Error);
  }
}

}  // namespace
}  // namespace bulletnav::sim
