// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include "agent/models/safetensors.h"
#include "benchmark/training/core/peers.h"
#include "benchmark/training/core/training.h"

namespace bulletnav::bench {

/// Where a training is, beside its weights, its optimiser and what else it appends.
struct TrainState {
  int step = 0;                                                // steps done
  double seconds = 0.0;                                        // that they took
  double best_loss = std::numeric_limits<double>::infinity();  // of the validations so far
};

inline constexpr const char* kCheckpointFile = "checkpoint.safetensors";

/// The newest checkpoint of a training and the one before, in its folder.
class Checkpoints {
 public:
  /// `essence`: what the training's result follows from, as text. Of several processes the first
  /// reads and writes, but all must call.
  Checkpoints(const std::filesystem::path& folder, std::string essence, Peers* peers);

  const std::filesystem::path& newest() const { return newest_; }

  /// Atomic; a failure leaves the one before. Throws FileError, say if there is no space.
  void Write(const TrainState& state, Training* training, const Optimiser& optimiser) const;

  /// Sets both as they were; none if there is no checkpoint. If the newest one is
  /// damaged, takes the one before. Throws Error if it belongs to a training by another config
  /// or if no checkpoint can be read.
  std::optional<TrainState> Read(Training* training, Optimiser* optimiser) const;

 private:
  TrainState Restore(const std::filesystem::path& file, const agent::TensorFile& content,
                     Training* training, Optimiser* optimiser) const;

  /// The file to go on from, and what it holds; none if there is no checkpoint.
  struct Found {
    std::filesystem::path file;
    agent::TensorFile content;
  };
  std::optional<Found> Find() const;
  std::optional<Found> FindTogether() const;

  Peers* peers_;
  std::filesystem::path newest_;
  std::filesystem::path previous_;
  std::string essence_;
};

}  // namespace bulletnav::bench
