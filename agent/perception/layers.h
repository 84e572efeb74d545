// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string_view>

#include "agent/perception/model_config.h"
#include "agent/perception/torch.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

/// How the left and right ends of a picture are continued.
enum class Ends { kZeros, kMeet };

/// A convolution without bias, then normalisation. Computes in the type of its input, its
/// parameters are float32. Square odd kernels; pads by half of one. The format of pictures is
/// [n, channels, rows, cols] in channels_last memory. Weights are Kaiming-normal.
/// Source: He et al., "Deep residual learning for image recognition", 2015.
class ConvNorm : public torch::nn::Module {
 public:
  struct Shape {
    int in = 0;
    int out = 0;
    int kernel = 3;
    int stride = 1;
    Ends ends = Ends::kZeros;
    Norm norm = Norm::kBatch;
    double scale = 1.0;  // of the results, at first
  };
  ConvNorm(const Shape& shape, sim::Rng* rng);

  torch::Tensor forward(const torch::Tensor& x);
  /// For inference only: the normalisation becomes part of the weights, kept in type `type`.
  void Fold(torch::ScalarType type);

 private:
  Shape shape_;
  torch::Tensor weight_;
  torch::Tensor scale_;
  torch::Tensor shift_;
  torch::Tensor mean_;
  torch::Tensor variance_;
  torch::Tensor folded_weight_;  // undefined until Fold
  torch::Tensor folded_bias_;
};

/// x * W^T + b over the last dimension of x. Weights are Kaiming-normal times `gain`.
class Dense : public torch::nn::Module {
 public:
  Dense(int in, int out, sim::Rng* rng, double gain = 1.0);
  torch::Tensor forward(const torch::Tensor& x);

 private:
  torch::Tensor weight_;
  torch::Tensor bias_;
};

/// The picture with `count` columns more at each end, continued from the other one.
torch::Tensor WrapColumns(const torch::Tensor& x, int count);

/// Leaves out values with this probability and scales the others up; nothing without a generator.
torch::Tensor Dropout(const torch::Tensor& x, double probability,
                      std::optional<at::Generator> generator);

/// Normal with this standard deviation, the same on every machine.
torch::Tensor NormalTensor(at::IntArrayRef shape, double deviation, sim::Rng* rng);

}  // namespace bulletnav::agent
