// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include <Eigen/Core>

#include "agent/perception/torch.h"
#include "agent/slam/descriptors/sequence_config.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

/// SeqVLAD while it is trained, in floats and before principal components; see agent::SeqVlad.
class SeqVladNet : public torch::nn::Module {
 public:
  SeqVladNet(const agent::SequenceConfig& config, std::uint64_t seed);

  const agent::SequenceConfig& config() const { return config_; }

  /// Clusters' middles by k-means of cells, rows of length 1; shares so that the nearest of two
  /// clusters gets most. Expects: at least as many cells as clusters (checked).
  void StartFrom(const Eigen::MatrixXf& cells, sim::Rng* rng);

  /// From [n, cells, channels] of length 1 each to [n, clusters * channels] of length 1.
  torch::Tensor forward(const torch::Tensor& cells) const;

 private:
  agent::SequenceConfig config_;
  torch::Tensor assign_;
  torch::Tensor centres_;
};

/// Vectors along the last axis, each made length 1; those of no length stay so.
torch::Tensor Directions(const torch::Tensor& x);

/// [n, cells, channels] of length 1 from bytes [n, cells, channels].
torch::Tensor CellDirections(std::span<const std::uint8_t> bytes, int n, int channels);

/// The main directions of rows [n, whole]: mean [whole] and projection [size, whole], orthonormal.
/// Fewer rows than directions leave the last ones zero.
struct MainDirections {
  torch::Tensor mean;
  torch::Tensor projection;
};
MainDirections MainDirectionsOf(const torch::Tensor& rows, int size);

/// Weights that agent::LoadSeqVlad reads.
void SaveSeqVlad(const SeqVladNet& net, const MainDirections& directions,
                 std::map<std::string, std::string> notes, const std::filesystem::path& file);

}  // namespace bulletnav::bench
