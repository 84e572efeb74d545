// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "agent/perception/torch.h"
#include "benchmark/training/core/measures.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// What one lane learns from in one step.
struct LaneWork {
  int step = 0;             // this one, from 0
  std::uint64_t first = 0;  // number of its first batch
  int count = 0;            // of batches
  std::uint64_t seed = 0;   // of dropout
};

/// A net and how it is taught. The same work gives the same loss and gradients, bit for bit.
class Learner {
 public:
  Learner() = default;
  virtual ~Learner() = default;
  Learner(const Learner&) = delete;
  Learner& operator=(const Learner&) = delete;
  Learner(Learner&&) = delete;
  Learner& operator=(Learner&&) = delete;

  virtual torch::nn::Module& net() = 0;
  /// To be gone back from; mean over the batches.
  virtual torch::Tensor Loss(const LaneWork& work) = 0;
  /// How well it does on what it does not learn from, with a net that infers. Always the same
  /// names, "loss" among them.
  virtual Measures Validate(sim::WorkerPool* pool) = 0;
  /// Writes weights that the agents can load; notes go into their metadata. Throws FileError.
  virtual void Save(std::map<std::string, std::string> notes,
                    const std::filesystem::path& file) const = 0;
};

}  // namespace bulletnav::bench
