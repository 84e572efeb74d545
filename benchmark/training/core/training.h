// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/training/core/measures.h"
#include "benchmark/training/core/optimiser.h"

namespace bulletnav::bench {

/// A line of the picture of a training's curves.
struct CurveLine {
  std::string title;
  std::string measure;
};

/// What one step of a training works with.
struct TrainStep {
  int step = 0;                    // from 0
  double rate = 0.0;               // of learning
  Optimiser* optimiser = nullptr;  // of the net
};

/// What is trained, and how: a net, its data and its loss. The core keeps time, checkpoints, curves
/// and weights; see RunTraining.
/// A training X is one file that ends in
///   const TrainerRegistration<X> registration;
/// and has `static constexpr std::string_view kName`, a `Config` that derives from TrainPlan, and a
/// constructor X(const Config&, const TrainContext&), which reads its data.
/// All that it does must follow from the config, the step and the state that it appends, or a
/// training that was killed will not end as one that was not.
class Training {
 public:
  Training() = default;
  virtual ~Training() = default;
  Training(const Training&) = delete;
  Training& operator=(const Training&) = delete;
  Training(Training&&) = delete;
  Training& operator=(Training&&) = delete;

  /// The same one, always; the core moves it to the plan's device before the first step.
  virtual torch::nn::Module& net() = 0;
  /// Absent: the project's own Adam, the same bits each time.
  virtual std::unique_ptr<Optimiser> MakeOptimiser() { return nullptr; }

  /// The learning rate of step 0, 1, ...; absent: the plan's schedule says it.
  virtual std::optional<double> RateAt(int /*step*/) const { return {}; }
  /// Learns once: gradients, and one or more steps of the optimiser. Returns the loss; one that is
  /// not finite ends the training. The net is in the state of training.
  virtual double Learn(const TrainStep& step) = 0;
  /// With a net that infers. Always the same names, "loss" (lower is better) among them.
  virtual Measures Validate() = 0;
  /// Observations (panoramas, frames, samples) shown in the first `steps` steps, counted as often
  /// as they were shown.
  virtual std::int64_t FramesAfter(int steps) const = 0;
  /// Those that the weights that it goes on from were trained with; the metadata of its own weights
  /// counts them in.
  virtual std::int64_t FramesBefore() const { return 0; }
  /// Whether several processes train it together, each with its share of the work and all with the
  /// same weights: then each calls the same functions, and the first one's files count.
  virtual bool shares_work() const { return false; }
  virtual std::string frames_are() const { return "frames"; }  // in words

  /// Writes weights that the agents can load; notes go into their metadata. Throws FileError.
  virtual void Save(std::map<std::string, std::string> notes,
                    const std::filesystem::path& file) const = 0;

  /// Puts a network in integers beside the trained one in a file that Save wrote, and returns what
  /// Validate says of it. Absent where there is no such network: then agents act in floats. Throws
  /// FileError.
  virtual std::optional<Measures> Quantise(const std::filesystem::path& /*file*/) { return {}; }

  /// State beside net and optimiser, such as where environments are: into a checkpoint and back.
  virtual void AppendState(agent::TensorFile* /*content*/) const {}
  virtual void SetState(const agent::TensorFile& /*content*/,
                        const std::filesystem::path& /*file*/) {}

  /// What is trained, for people.
  virtual std::string title() const = 0;
  /// A validation, in a line.
  virtual std::string Describe(const Measures& measures) const = 0;
  virtual std::string curves_label() const { return "validation"; }  // of the picture's y axis
  virtual std::vector<CurveLine> curves() const { return {{"loss", "loss"}}; }
  /// Rows of the card that goes with the weights.
  virtual std::vector<std::pair<std::string, std::string>> CardRows() const { return {}; }
  /// On what Validate tries the net.
  virtual std::string validated_on() const { return "what it is validated on"; }
};

}  // namespace bulletnav::bench
