// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include "agent/models/safetensors.h"
#include "agent/perception/torch.h"
#include "benchmark/training/core/adam.h"

namespace bulletnav::bench {

/// Where a training is, beside its weights and its optimiser. All that is random and the batches
/// follow from the seed and the step.
struct TrainState {
  int step = 0;                                                // steps done
  double seconds = 0.0;                                        // that they took
  double best_loss = std::numeric_limits<double>::infinity();  // of the validations so far
};

/// The newest checkpoint of a training and the one before, in its folder.
class Checkpoints {
 public:
  /// `essence`: what the training's result follows from, as text.
  Checkpoints(const std::filesystem::path& folder, std::string essence);

  const std::filesystem::path& newest() const { return newest_; }

  /// Atomic; a failure leaves the one before. Throws FileError, say if there is no space.
  void Write(const TrainState& state, const torch::nn::Module& net, const Adam& adam) const;

  /// Sets `net` and `adam` as they were; none if there is no checkpoint. If the newest one is
  /// damaged, takes the one before. Throws Error if it belongs to a training by another config
  /// or if no checkpoint can be read.
  std::optional<TrainState> Read(torch::nn::Module* net, Adam* adam) const;

 private:
  TrainState Restore(const std::filesystem::path& file, const agent::TensorFile& content,
                     torch::nn::Module* net, Adam* adam) const;

  std::filesystem::path newest_;
  std::filesystem::path previous_;
  std::string essence_;
};

}  // namespace bulletnav::bench
