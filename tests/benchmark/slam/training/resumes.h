// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include <gtest/gtest.h>

#include "agent/models/safetensors.h"
#include "tests/benchmark/training/supervised/watchers.h"

namespace bulletnav::tests {

/// Trains to the end in folder/whole, and in folder/parts with a kill after step 5: both are to end
/// with the same weights. Returns the measures of the first. `train(config, observer)`; a
/// checkpoint every second step.
template <class Config, class Train>
bench::Measures ExpectResumesToTheSameBits(Config config, const std::filesystem::path& folder,
                                           const Train& train) {
  config.out = (folder / "whole").string();
  Watcher whole;
  train(config, &whole);
  const auto weights = agent::ReadTensorFile(folder / "whole/weights.safetensors").tensors;
  config.out = (folder / "parts").string();
  Watcher killed(5);
  EXPECT_THROW(train(config, &killed), Killed);
  Watcher rest;
  train(config, &rest);
  EXPECT_EQ(rest.resumed(), 4);
  EXPECT_EQ(agent::ReadTensorFile(folder / "parts/weights.safetensors").tensors, weights);
  return whole.measures();
}

}  // namespace bulletnav::tests
