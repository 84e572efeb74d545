// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>

namespace torch::nn {
class Module;
}
namespace bulletnav::agent {
struct TensorFile;
}

namespace bulletnav::bench {

struct OptimiserSpec;

/// Moves a net's parameters along their gradients. Its state is part of the checkpoints.
class Optimiser {
 public:
  Optimiser() = default;
  virtual ~Optimiser() = default;
  Optimiser(const Optimiser&) = delete;
  Optimiser& operator=(const Optimiser&) = delete;
  Optimiser(Optimiser&&) = delete;
  Optimiser& operator=(Optimiser&&) = delete;

  /// Moves each parameter that has a gradient, then forgets the gradients.
  virtual void Step(double rate) = 0;

  /// The state, as tensors and metadata whose names start with the optimiser's.
  virtual void Append(agent::TensorFile* content) const = 0;
  /// Throws FileError, naming `file`, unless the state of each parameter is there in its shape.
  virtual void Set(const agent::TensorFile& content, const std::filesystem::path& file) = 0;
};

/// torch::optim::Adam, for those to whom its speed on an accelerator matters; with the spec's
/// weight decay on the gradients, as torch has it. The net's parameters must stay where they are.
std::unique_ptr<Optimiser> MakeTorchAdam(const torch::nn::Module& net, const OptimiserSpec& spec);

}  // namespace bulletnav::bench
