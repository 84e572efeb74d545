// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "agent/slam/descriptors/sequence_config.h"
#include "benchmark/slam/training/place_config.h"
#include "benchmark/slam/training/sequence_walks.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/core/training.h"

namespace bulletnav::bench {

/// A training of the descriptor of sequences. Numbers of the loss are of Mereu et al., "Learning
/// sequential descriptors for sequence-based visual place recognition", RA-L 2022.
struct SeqVladTrainConfig : TrainPlan {
  std::optional<PlaceDataConfig> data;        // scenes, body and camera; not its places
  std::optional<PlaceDataConfig> validation;  // default: the houses' split "val"
  std::string descriptor;                     // weights of the network that sees the pictures
  agent::SequenceConfig model;
  int walk_scenes = 12;  // the first ones; 0: all. Source: the second paper, section IV-A
  int walks = 2;         // through each
  int frames = 700;      // of a walk
  int shortest = 5;      // frames of a sequence that is learned from
  int longest = 5;
  int queries = 16;   // a step
  int negatives = 5;  // of each query, from its own walk
  double margin = 0.1;

  SeqVladTrainConfig() {
    task = "seqvlad";
    optimiser.learning_rate = 1e-4;
  }

  template <class V>
  void Visit(V& v) {
    v("task", task);
    v.Required("out", out);
    v("data", data);
    v("validation", validation);
    v.Required("descriptor", descriptor);
    v("model", model);
    v("walk_scenes", walk_scenes);
    v("walks", walks);
    v("frames", frames);
    v("shortest", shortest);
    v("longest", longest);
    v("optimiser", optimiser);
    v("steps", steps);
    v("queries", queries);
    v("negatives", negatives);
    v("margin", margin);
    v("validate_every", validate_every);
    v("seed", seed);
    v("device", device);
  }
  /// Throws Error.
  void Validate() const;
};

/// The training of SeqVLAD on what a trained network sees on walks: sequences whose frames are
/// covisible are to lie nearer than those that share nothing, by a margin. One thread; the same
/// bits each time. Weights hold principal components of sequences of training besides.
class SeqVladTraining final : public Training {
 public:
  static constexpr std::string_view kName = "seqvlad";
  using Config = SeqVladTrainConfig;

  SeqVladTraining(const Config& config, const TrainContext& context);
  SeqVladTraining(const Config& config, std::vector<SequenceWalk> train,
                  std::vector<SequenceWalk> validation);
  ~SeqVladTraining() override;
  SeqVladTraining(const SeqVladTraining&) = delete;
  SeqVladTraining& operator=(const SeqVladTraining&) = delete;
  SeqVladTraining(SeqVladTraining&&) = delete;
  SeqVladTraining& operator=(SeqVladTraining&&) = delete;

  torch::nn::Module& net() override;
  double Learn(const TrainStep& step) override;
  Measures Validate() override;
  std::int64_t FramesAfter(int steps) const override;
  std::string frames_are() const override { return "sequences"; }
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override;
  std::optional<Measures> Quantise(const std::filesystem::path& file) override;
  std::string title() const override { return "The descriptor of sequences"; }
  std::string Describe(const Measures& measures) const override;
  std::vector<CurveLine> curves() const override { return {{"AP", "ap"}}; }
  std::string validated_on() const override { return "sequences of walks in validation scenes"; }

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace bulletnav::bench
