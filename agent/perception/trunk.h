// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "agent/perception/layers.h"

namespace bulletnav::agent {

/// The convolutions of ResNet18 with any number of channels: a stem that divides rows and columns
/// by four, then four stages of two blocks with width, 2, 4 and 8 width channels. `halvings` of the
/// last three stages, the first of them, halve once more; ResNet18 has three.
/// Cell (i, j) of the result is centred at pixel (i, j) times the whole division.
/// Source: He et al., "Deep residual learning for image recognition", 2015.
class Trunk : public torch::nn::Module {
 public:
  struct Shape {
    int in = 3;
    int width = 64;
    int halvings = 3;
    Ends ends = Ends::kZeros;
    Norm norm = Norm::kBatch;
  };
  Trunk(const Shape& shape, sim::Rng* rng);

  /// [n, in, rows, cols] to [n, features, rows / d, cols / d].
  torch::Tensor forward(const torch::Tensor& x) { return Stages(x).back(); }
  /// What each of the four stages comes to, the result last.
  std::vector<torch::Tensor> Stages(const torch::Tensor& x);
  void Fold(torch::ScalarType type);

 private:
  struct Block {
    std::shared_ptr<ConvNorm> first;
    std::shared_ptr<ConvNorm> second;
    std::shared_ptr<ConvNorm> shortcut;  // null where input and output have one shape
  };
  std::shared_ptr<ConvNorm> Add(const std::string& name, const ConvNorm::Shape& shape,
                                sim::Rng* rng);
  void AddBlock(const std::string& name, ConvNorm::Shape shape, sim::Rng* rng);

  Ends ends_;
  Norm norm_;
  std::vector<std::shared_ptr<ConvNorm>> layers_;
  std::shared_ptr<ConvNorm> stem_;
  std::vector<Block> blocks_;
};

}  // namespace bulletnav::agent
