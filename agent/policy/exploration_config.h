// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>

#include "agent/models/safetensors.h"
#include "agent/perception/model_config.h"

namespace bulletnav::agent {

/// The key of a file's metadata that holds an exploration policy's configuration as YAML.
inline constexpr const char* kExplorationKey = "exploration";

/// Channels of its five convolutions, 3 x 3; after each of the first three, the largest of 2 x 2
/// are kept.
inline constexpr std::array kExplorationWidths = {32, 64, 128, 64, 32};
inline constexpr int kExplorationPools = 3;
inline constexpr int kExplorationCodes = 15 * 15 * 32;

/// The shape of an exploration policy; goes with its weights. Source: the network of Active Neural
/// SLAM's global policy, whose sizes are the defaults.
struct ExplorationConfig {
  int features = 256;    // of both fully connected layers
  int heading_size = 8;  // numbers that a heading becomes
  Precision precision = Precision::kBfloat16;

  bool operator==(const ExplorationConfig&) const = default;

  template <class V>
  void Visit(V& v) {
    v("features", features);
    v("heading_size", heading_size);
    v("precision", precision);
  }
  /// Throws Error.
  void Validate() const;
};

/// Throws FileError if it is missing or bad.
ExplorationConfig ExplorationConfigOf(const TensorFile& weights, const std::filesystem::path& file);

}  // namespace bulletnav::agent
