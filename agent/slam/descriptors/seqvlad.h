// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "agent/models/safetensors.h"
#include "agent/slam/descriptors/sequence_config.h"
#include "agent/slam/retrieval/sequence_model.h"

namespace bulletnav::agent {

/// The tensor that principal components are in.
inline constexpr const char* kProjection = "projection";

/// Describes sequences by what their pictures' cells differ from the middles of clusters by, each
/// cell sharing itself out among clusters; then principal components. Cells are directions, what
/// clusters have in sum is made one long each, and so is the whole. The number of pictures does not
/// matter. All in whole numbers, rounded from the weights: the same bytes on every processor.
/// Tensors "assign" and "centres" [clusters, channels], "mean" [whole], "projection" [size, whole];
/// the last also as a layer in 8 bits, which is half as large.
/// Source: Mereu et al., "Learning sequential descriptors for sequence-based visual place
/// recognition", RA-L 2022; Arandjelovic et al., "NetVLAD", CVPR 2016.
class SeqVlad final : public SequenceModel {
 public:
  /// Throws FileError, naming `file`, unless all tensors are there and of the right shape.
  SeqVlad(const TensorFile& weights, const std::filesystem::path& file);

  const SequenceConfig& config() const { return config_; }

  /// Expects: whole cells, at least one (checked).
  void Add(std::span<const std::uint8_t> cells, Sum* sum) const override;
  PictureDescriptor Describe(const Sum& sum) const override;
  /// Before principal components: [clusters, channels], each cluster a direction.
  std::vector<std::int16_t> Whole(const Sum& sum) const;

 private:
  /// How much a cell's direction is like a cluster, in 2^-kLogitBits.
  std::int32_t LogitOf(const PictureDescriptor& cell, std::size_t cluster) const;
  /// Adds a share of how a cell's direction differs from a cluster's centre.
  void AddShare(const PictureDescriptor& cell, std::size_t cluster, std::int64_t share,
                Sum* sum) const;

  SequenceConfig config_;
  std::vector<std::int32_t> assign_;   // [clusters, channels] logits in 2^-kLogitBits
  std::vector<std::int32_t> centres_;  // [clusters, channels] in steps of kDescriptorUnit
  std::vector<std::int32_t> mean_;     // [whole]
  std::vector<std::int32_t> projection_;
};

/// From a file of weights. Throws FileError if there is none, or it cannot be used.
std::shared_ptr<const SeqVlad> LoadSeqVlad(const std::filesystem::path& weights);

}  // namespace bulletnav::agent
