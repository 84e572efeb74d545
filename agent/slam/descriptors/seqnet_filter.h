// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "agent/models/safetensors.h"
#include "agent/slam/retrieval/sequence_filter.h"

namespace bulletnav::agent {

/// Where the metadata of a file of weights hold a SeqNetConfig, as YAML.
inline constexpr const char* kSeqNetKey = "seqnet";

/// The shape of SeqNet's filter; goes with its weights.
struct SeqNetConfig {
  int length = 5;  // pictures in a row; w of the paper

  bool operator==(const SeqNetConfig&) const = default;

  template <class V>
  void Visit(V& v) {
    v("length", length);
  }
  /// Throws Error.
  void Validate() const;
};

/// SeqNet's learned filter over time: each number of a sequence's descriptor is a weighted sum of
/// all numbers of its pictures' descriptors, then length 1. In whole numbers, rounded from the
/// weights: the same bytes on every processor. Tensors "filter" [size, length, size] and "bias"
/// [size]. Source: Garg and Milford, "SeqNet: learning descriptors for sequence-based hierarchical
/// place recognition", RA-L 2021, with sequences as long as the filter.
class SeqNetFilter final : public SequenceFilter {
 public:
  /// Throws FileError, naming `file`, unless all tensors are there and of the right shape.
  SeqNetFilter(const TensorFile& weights, const std::filesystem::path& file);

  int length() const override { return config_.length; }
  int size() const override { return size_; }
  PictureDescriptor Describe(std::span<const PictureDescriptor> pictures) const override;

 private:
  SeqNetConfig config_;
  int size_ = 0;
  std::vector<std::int32_t> filter_;  // [size, length, size] in 2^-14
  std::vector<std::int32_t> bias_;    // [size] in 2^-14
};

/// From a file of weights. Throws FileError if there is none, or it cannot be used.
std::shared_ptr<const SeqNetFilter> LoadSeqNetFilter(const std::filesystem::path& weights);

}  // namespace bulletnav::agent
