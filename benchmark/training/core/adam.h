// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "agent/models/safetensors.h"
#include "agent/perception/torch.h"
#include "benchmark/training/core/optimiser.h"
#include "benchmark/training/core/train_plan.h"

namespace bulletnav::bench {

/// Adam, with its state as plain tensors that can be written and read. Decay acts on the weights
/// themselves. Sources: Kingma and Ba, "Adam", 2014; Loshchilov and Hutter, "Decoupled weight decay
/// regularization", 2017.
class Adam final : public Optimiser {
 public:
  /// For the module's parameters; they must stay where they are. The rate of the spec is not
  /// looked at: Step is told it.
  Adam(const torch::nn::Module& module, const OptimiserSpec& spec);

  void Step(double rate) override;
  void Append(agent::TensorFile* content) const override;
  void Set(const agent::TensorFile& content, const std::filesystem::path& file) override;

 private:
  struct Item {
    std::string name;
    torch::Tensor parameter;
    torch::Tensor mean;      // of gradients, decaying
    torch::Tensor variance;  // of gradients, around zero, as above
    int steps = 0;           // with a gradient: how many are in the two above
  };
  std::vector<Item> items_;
  double weight_decay_;
  double epsilon_;
};

}  // namespace bulletnav::bench
