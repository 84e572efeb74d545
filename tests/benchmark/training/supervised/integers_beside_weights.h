// SPDX-License-Identifier: MIT
#pragma once
#include <cstdio>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "agent/models/model_registry.h"
#include "agent/models/safetensors.h"
#include "sim/base/files.h"

namespace bulletnav::tests {

/// Of a training's folder: integers in the last weights, and a card that tells both accuracies.
inline void ExpectIntegersBesideWeights(const std::filesystem::path& folder) {
  EXPECT_TRUE(agent::HoldsIntegers(agent::ReadTensorFile(folder / "weights.safetensors")));
  EXPECT_FALSE(agent::HoldsIntegers(agent::ReadTensorFile(folder / "weights_best.safetensors")));
  // As trained, in integers: near each other.
  const std::string card = sim::ReadTextFile(folder / "weights.md");
  EXPECT_THAT(card, testing::HasSubstr("| measure | as trained | in integers |"));
  double floats = 0.0;
  double integers = 0.0;
  const std::size_t row = card.find("| loss | ");
  ASSERT_NE(row, std::string::npos) << card;
  ASSERT_EQ(std::sscanf(card.c_str() + row, "| loss | %lf | %lf |", &floats, &integers), 2);
  EXPECT_NEAR(floats, integers, 0.05 * floats) << card;
}

}  // namespace bulletnav::tests
