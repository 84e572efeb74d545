// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "agent/models/safetensors.h"
#include "agent/perception/model_config.h"

namespace bulletnav::agent {

/// Where the metadata of a file of weights hold a DescriptorConfig, as YAML.
inline constexpr const char* kDescriptorKey = "descriptor";
/// Where the metadata of weights that were learned from what a descriptor's network sees hold the
/// hash of that network's file.
inline constexpr const char* kDescriptorHashKey = "descriptor_hash";

/// The shape of the network that describes flat pictures; goes with its weights.
struct DescriptorConfig {
  int width = 32;  // channels of the trunk's first stage; 64 is ResNet18
  int rows = 96;   // pictures are averaged down to rows x 4/3 rows: 96 or 48
  int size = 256;  // numbers of a descriptor
  Precision precision = Precision::kBfloat16;

  bool operator==(const DescriptorConfig&) const = default;
  int cols() const { return rows / 3 * 4; }

  template <class V>
  void Visit(V& v) {
    v("width", width);
    v("rows", rows);
    v("size", size);
    v("precision", precision);
  }
  /// Throws Error.
  void Validate() const;
};

/// How often stages two to four of the trunk halve rows and columns: as in the models for
/// panoramas of 64 rows, whose trunk it may start from.
inline constexpr int kDescriptorHalvings = 2;

/// GeM's exponent is kept within these.
inline constexpr double kLeastExponent = 1.0;
inline constexpr double kMostExponent = 8.0;

/// The configuration that the weights belong to; `file` is named in errors. Throws FileError if it
/// is missing or bad.
DescriptorConfig DescriptorConfigOf(const TensorFile& weights, const std::filesystem::path& file);

}  // namespace bulletnav::agent
