// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "agent/models/safetensors.h"
#include "agent/perception/torch.h"

namespace bulletnav::bench {

/// Adam, with its state as plain tensors that can be written and read. Decay acts on the weights
/// themselves. Sources: Kingma and Ba, "Adam", 2014; Loshchilov and Hutter, "Decoupled weight decay
/// regularization", 2017.
class Adam {
 public:
  /// For the module's parameters; they must stay where they are.
  explicit Adam(const torch::nn::Module& module);

  /// Moves each parameter that has a gradient, then forgets the gradients.
  void Step(double rate, double weight_decay);

  /// The state, as tensors whose names start with "adam.". The number of steps is not part of it.
  void Append(agent::TensorFile* content) const;
  /// Throws FileError, naming `file`, unless there is one of the right shape for each parameter.
  void Set(const agent::TensorFile& content, const std::filesystem::path& file, int steps);

 private:
  struct Item {
    std::string name;
    torch::Tensor parameter;
    torch::Tensor mean;      // of gradients, decaying
    torch::Tensor variance;  // of gradients, around zero, likewise
  };
  std::vector<Item> items_;
  int steps_ = 0;
};

}  // namespace bulletnav::bench
