// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "agent/models/safetensors.h"

namespace bulletnav::agent {

/// Where the metadata of a file of weights hold a SequenceConfig, as YAML.
inline constexpr const char* kSequenceKey = "sequence";

/// The shape of SeqVLAD; goes with its weights.
struct SequenceConfig {
  int clusters = 64;
  int channels = 128;  // of a cell: four times the width of the network that sees the cells
  int size = 512;      // numbers of a descriptor

  bool operator==(const SequenceConfig&) const = default;
  int whole() const { return clusters * channels; }

  template <class V>
  void Visit(V& v) {
    v("clusters", clusters);
    v("channels", channels);
    v("size", size);
  }
  /// Throws Error.
  void Validate() const;
};

/// The configuration that the weights belong to; `file` is named in errors. Throws FileError if it
/// is missing or bad.
SequenceConfig SequenceConfigOf(const TensorFile& weights, const std::filesystem::path& file);

}  // namespace bulletnav::agent
