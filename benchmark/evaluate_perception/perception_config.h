// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "benchmark/training/supervised/data_config.h"

namespace bulletnav::bench {

/// What learned functions are measured on, and how: the file of `evaluate-perception`.
struct PerceptionConfig {
  std::string weights = "assets/weights/nts_rgbd.safetensors";
  DataConfig data;  // scenes that the weights have not seen; 60 points each, unless told
  /// Probabilities from which the answer is yes; those that agents use, see agent::NtsSpec.
  double same_node = 0.8;
  double explorable = 0.5;
  int pictures = 3;        // of each kind
  std::uint64_t seed = 0;  // of which examples are drawn, and of confidence intervals
  std::string out = "results/perception";

  PerceptionConfig() { data.points = 60; }
  template <class V>
  void Visit(V& v) {
    v("weights", weights);
    v.Required("data", data);
    v("same_node", same_node);
    v("explorable", explorable);
    v("pictures", pictures);
    v("seed", seed);
    v("out", out);
  }
  /// Throws sim::Error.
  void Validate() const;
};

}  // namespace bulletnav::bench
