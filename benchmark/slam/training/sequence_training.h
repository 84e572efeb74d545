// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "agent/perception/torch.h"
#include "agent/slam/retrieval/picture_descriptor.h"
#include "benchmark/slam/training/place_config.h"
#include "benchmark/slam/training/sequence_walks.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/core/training.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

/// What all trainings of descriptors of sequences are told. Numbers of the loss are of Mereu et
/// al., "Learning sequential descriptors for sequence-based visual place recognition", RA-L 2022.
struct SequencePlan : TrainPlan {
  std::optional<PlaceDataConfig> data;        // scenes, body and camera; not its places
  std::optional<PlaceDataConfig> validation;  // default: the houses' split "val"
  std::string descriptor;                     // weights of the network that sees the pictures
  int walk_scenes = 12;  // the first ones; 0: all. Source: the second paper, section IV-A
  int walks = 2;         // through each
  int frames = 700;      // of a walk
  int queries = 16;      // a step
  int negatives = 5;     // of each query, from its own walk
  double margin = 0.1;

  SequencePlan() { optimiser.learning_rate = 1e-4; }

  template <class V>
  void Visit(V& v) {
    v("task", task);
    v.Required("out", out);
    v("data", data);
    v("validation", validation);
    v.Required("descriptor", descriptor);
    v("walk_scenes", walk_scenes);
    v("walks", walks);
    v("frames", frames);
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

/// Frames of the sequences that are learned from.
struct SequenceLengths {
  int shortest = 5;
  int longest = 5;
};

struct SequenceWalks {
  std::vector<SequenceWalk> train;
  std::vector<SequenceWalk> validation;
  std::string descriptor_hash = {};  // FileHash of the network that saw them; empty: not known
};

/// A training of a descriptor of sequences on what a trained network sees on walks: sequences whose
/// frames are covisible are to lie nearer than those that share nothing, by a margin. One thread;
/// the same bits each time.
class SequenceTraining : public Training {
 public:
  double Learn(const TrainStep& step) override;
  /// Whose descriptors the weights belong to is said in them.
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override;
  Measures Validate() override;
  std::int64_t FramesAfter(int steps) const override;
  std::string frames_are() const override { return "sequences"; }
  std::string Describe(const Measures& measures) const override;
  std::vector<CurveLine> curves() const override { return {{"AP", "ap"}}; }
  std::string validated_on() const override { return "sequences of walks in validation scenes"; }

 protected:
  /// Walks through the plan's scenes. Throws Error.
  static SequenceWalks MakeWalks(const SequencePlan& plan, const TrainContext& context);

  /// `name`: of the training, of whose random numbers it is a part. Throws Error for walks that are
  /// not there or too short.
  SequenceTraining(const SequencePlan& plan, const SequenceLengths& lengths, std::string name,
                   SequenceWalks walks);

  /// As Save, in one thread and without gradients.
  virtual void SaveNet(std::map<std::string, std::string> notes,
                       const std::filesystem::path& file) const = 0;
  /// Windows of one length of a walk as the net describes them: [n, size] of length 1.
  virtual torch::Tensor DescribeWindows(const SequenceWalk& walk,
                                        std::span<const Window> windows) = 0;
  /// What Validate says of a network in integers.
  using InIntegers =
      std::function<agent::PictureDescriptor(const SequenceWalk& walk, const Window& window)>;
  Measures MeasuresOf(const InIntegers& describe) const;

  const SequenceWalks& walks() const { return walks_; }
  /// A window of a length that is learned from.
  Window DrawWindow(const SequenceWalk& walk, sim::Rng* rng) const;

 private:
  struct Triplet;
  Triplet DrawTriplet(int query_length, int length, sim::Rng* rng) const;
  torch::Tensor LossOf(int step);
  template <class Describer, class Cosine>
  Measures Rank(const Describer& describe, const Cosine& cosine) const;

  SequencePlan plan_;
  SequenceLengths lengths_;
  std::string name_;
  SequenceWalks walks_;
};

}  // namespace bulletnav::bench
