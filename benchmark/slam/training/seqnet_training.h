// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agent/slam/descriptors/seqnet_filter.h"
#include "benchmark/slam/training/sequence_training.h"

namespace bulletnav::bench {

/// A training of SeqNet's filter over time.
struct SeqNetTrainConfig : SequencePlan {
  agent::SeqNetConfig model;

  SeqNetTrainConfig() { task = "seqnet"; }

  template <class V>
  void Visit(V& v) {
    SequencePlan::Visit(v);
    v("model", model);
  }
  /// Throws Error.
  void Validate() const;
};

/// SeqNet's filter while it is trained, in floats; see agent::SeqNetFilter. It begins as the mean
/// of its pictures.
class SeqNetNet : public torch::nn::Module {
 public:
  SeqNetNet(const agent::SeqNetConfig& config, int size);

  /// From descriptors [n, length, size] to [n, size] of length 1.
  torch::Tensor forward(const torch::Tensor& descriptors) const;

 private:
  torch::Tensor filter_;  // [size, length, size]
  torch::Tensor bias_;    // [size]
};

/// Weights that agent::LoadSeqNetFilter reads.
void SaveSeqNet(const SeqNetNet& net, const agent::SeqNetConfig& config,
                std::map<std::string, std::string> notes, const std::filesystem::path& file);

/// The training of SeqNet's filter, from the descriptors of pictures, which are not trained.
class SeqNetTraining final : public SequenceTraining {
 public:
  static constexpr std::string_view kName = "seqnet";
  using Config = SeqNetTrainConfig;

  SeqNetTraining(const Config& config, const TrainContext& context);
  SeqNetTraining(const Config& config, SequenceWalks walks);

  torch::nn::Module& net() override { return net_; }
  std::optional<Measures> Quantise(const std::filesystem::path& file) override;
  std::string title() const override { return "SeqNet's filter over time"; }

 private:
  void SaveNet(std::map<std::string, std::string> notes,
               const std::filesystem::path& file) const override;
  torch::Tensor DescribeWindows(const SequenceWalk& walk, std::span<const Window> windows) override;

  Config config_;
  SeqNetNet net_;
};

}  // namespace bulletnav::bench
