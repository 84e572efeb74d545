// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "agent/perception/torch.h"
#include "benchmark/training/core/measures.h"
#include "benchmark/training/supervised/pair_batch.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// What one lane learns from in one step.
struct LaneWork {
  const BatchSource* batches = nullptr;
  int step = 0;             // this one, from 0
  std::uint64_t first = 0;  // number of its first batch
  int count = 0;            // of batches
  std::uint64_t seed = 0;   // of dropout
};

/// What a network in integers is made from and tried on.
struct QuantiseWork {
  const BatchSource* train = nullptr;
  const BatchSource* validation = nullptr;
  int count = 0;  // of batches of validation
  sim::WorkerPool* pool = nullptr;
  std::filesystem::path file;
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
  /// On batches number 0 on, with a net that infers. Always the same names, "loss" among them.
  virtual Measures Validate(const BatchSource& batches, int count, sim::WorkerPool* pool) = 0;
  /// See Training::Quantise; scales are from batches number 0 on that it learned from.
  virtual std::optional<Measures> Quantise(const QuantiseWork& work) = 0;
  /// Writes weights that the agents can load; notes go into their metadata. Throws FileError.
  virtual void Save(std::map<std::string, std::string> notes,
                    const std::filesystem::path& file) const = 0;
};

/// Always the same net.
using LearnerMaker = std::function<std::unique_ptr<Learner>()>;

}  // namespace bulletnav::bench
