// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "benchmark/evaluate_perception/perception_figures.h"

namespace bulletnav::bench {

/// Where figures come from.
struct PerceptionSource {
  std::string weights;       // file
  std::string weights_hash;  // of its bytes
  std::string program;       // version
};

/// Keys: weights, weights_hash, program, data (scenes' index or files, split, points, seed) and
/// those of PerceptionFigures::Visit; shares in [0, 1], metres and degrees where a key ends so. A
/// mean is {count, value, low, high}; null is what cannot be said.
std::string ToJson(const PerceptionFigures& figures, const PerceptionConfig& config,
                   const PerceptionSource& source);
/// Tables for people, what guessing would give beside each figure.
std::string ToMarkdown(const PerceptionFigures& figures, const PerceptionConfig& config,
                       const PerceptionSource& source);

}  // namespace bulletnav::bench
