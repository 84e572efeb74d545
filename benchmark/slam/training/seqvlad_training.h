// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agent/slam/descriptors/sequence_config.h"
#include "benchmark/slam/training/sequence_training.h"
#include "benchmark/slam/training/seqvlad_net.h"

namespace bulletnav::bench {

/// A training of SeqVLAD.
struct SeqVladTrainConfig : SequencePlan {
  agent::SequenceConfig model;
  int shortest = 5;  // frames of a sequence that is learned from
  int longest = 5;

  SeqVladTrainConfig() { task = "seqvlad"; }

  template <class V>
  void Visit(V& v) {
    SequencePlan::Visit(v);
    v("model", model);
    v("shortest", shortest);
    v("longest", longest);
  }
  /// Throws Error.
  void Validate() const;
};

/// The training of SeqVLAD, from the cells of pictures. Weights hold principal components of
/// sequences of training besides.
class SeqVladTraining final : public SequenceTraining {
 public:
  static constexpr std::string_view kName = "seqvlad";
  using Config = SeqVladTrainConfig;

  SeqVladTraining(const Config& config, const TrainContext& context);
  SeqVladTraining(const Config& config, SequenceWalks walks);

  torch::nn::Module& net() override { return net_; }
  std::optional<Measures> Quantise(const std::filesystem::path& file) override;
  std::string title() const override { return "The descriptor of sequences"; }

 private:
  void SaveNet(std::map<std::string, std::string> notes,
               const std::filesystem::path& file) const override;
  torch::Tensor DescribeWindows(const SequenceWalk& walk, std::span<const Window> windows) override;
  torch::Tensor CellsOf(const SequenceWalk& walk, std::span<const Window> windows) const;
  Eigen::MatrixXf SomeCells(sim::Rng* rng) const;
  MainDirections Directions() const;

  Config config_;
  SeqVladNet net_;
};

}  // namespace bulletnav::bench
