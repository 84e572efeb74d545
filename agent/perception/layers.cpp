// SPDX-License-Identifier: MIT
#include "agent/perception/layers.h"

#include <array>
#include <cmath>

#include <torch/csrc/autograd/custom_function.h>

namespace bulletnav::agent {
namespace {

constexpr double kNormEpsilon = 1e-5;
constexpr double kNormMomentum = 0.1;

/// Torch's own gradient fills and adds up three tensors of the whole picture's size; this copies
/// the middle and adds the ends to it, which makes the same numbers.
struct WrapFunction : torch::autograd::Function<WrapFunction> {
  static torch::Tensor forward(torch::autograd::AutogradContext* context, const torch::Tensor& x,
                               std::int64_t count) {
    context->saved_data["count"] = count;
    // Rows of pixels are contiguous here, so that the copies are long.
    const torch::Tensor pixels = x.permute({0, 2, 3, 1});
    const std::int64_t cols = pixels.size(2);
    return at::cat({pixels.narrow(2, cols - count, count), pixels, pixels.narrow(2, 0, count)}, 2)
        .permute({0, 3, 1, 2});
  }
  static torch::autograd::variable_list backward(torch::autograd::AutogradContext* context,
                                                 torch::autograd::variable_list of_wrapped) {
    const std::int64_t count = context->saved_data["count"].toInt();
    const torch::Tensor wrapped = of_wrapped[0].permute({0, 2, 3, 1});
    const std::int64_t cols = wrapped.size(2) - 2 * count;
    torch::Tensor pixels = wrapped.narrow(2, count, cols).clone(at::MemoryFormat::Contiguous);
    pixels.narrow(2, 0, count).add_(wrapped.narrow(2, cols + count, count));
    pixels.narrow(2, cols - count, count).add_(wrapped.narrow(2, 0, count));
    return {pixels.permute({0, 3, 1, 2}), torch::Tensor()};
  }
};

}  // namespace

torch::Tensor NormalTensor(at::IntArrayRef shape, double deviation, sim::Rng* rng) {
  torch::Tensor values = torch::empty(shape, torch::kFloat32);
  float* data = values.data_ptr<float>();
  for (std::int64_t i = 0; i < values.numel(); ++i) {
    data[i] = static_cast<float>(deviation * rng->Normal());
  }
  return values;
}

torch::Tensor WrapColumns(const torch::Tensor& x, int count) {
  return WrapFunction::apply(x, count);
}

torch::Tensor Dropout(const torch::Tensor& x, double probability,
                      std::optional<at::Generator> generator) {
  if (!generator || probability == 0.0) return x;
  const double keep = 1.0 - probability;
  torch::Tensor mask = torch::empty(x.sizes(), torch::kFloat32).bernoulli_(keep, *generator);
  return x * mask.div_(keep).to(x.device());
}

ConvNorm::ConvNorm(const Shape& shape, sim::Rng* rng) : shape_(shape) {
  const double fan_out = shape.out * shape.kernel * shape.kernel;
  weight_ =
      register_parameter("weight", NormalTensor({shape.out, shape.in, shape.kernel, shape.kernel},
                                                std::sqrt(2.0 / fan_out), rng));
  scale_ = register_parameter("scale", at::full({shape.out}, shape.scale));
  shift_ = register_parameter("shift", torch::zeros({shape.out}));
  mean_ = register_buffer("mean", torch::zeros({shape.out}));
  variance_ = register_buffer("variance", torch::ones({shape.out}));
}

torch::Tensor ConvNorm::forward(const torch::Tensor& x) {
  const int pad = shape_.kernel / 2;
  const bool wraps = shape_.ends == Ends::kMeet && pad > 0;
  const torch::Tensor padded = wraps ? WrapColumns(x, pad) : x;
  const std::array<std::int64_t, 2> padding = {pad, wraps ? 0 : pad};
  const std::array<std::int64_t, 2> stride = {shape_.stride, shape_.stride};
  if (folded_weight_.defined()) {
    // By name: small float32 convolutions of one picture would not go to oneDNN by themselves.
    if (x.is_cpu()) {
      return at::mkldnn_convolution(padded, folded_weight_, folded_bias_, padding, stride, {1, 1},
                                    1);
    }
    return at::conv2d(padded, folded_weight_, folded_bias_, stride, padding);
  }
  if (shape_.norm == Norm::kFixed) {
    const torch::Tensor factor = scale_ / (variance_ + kNormEpsilon).sqrt();
    const torch::Tensor fixed = (weight_ * factor.view({-1, 1, 1, 1})).to(x.scalar_type());
    return at::conv2d(padded, fixed.contiguous(at::MemoryFormat::ChannelsLast),
                      (shift_ - mean_ * factor).to(x.scalar_type()), stride, padding);
  }
  const torch::Tensor weight =
      weight_.to(x.scalar_type()).contiguous(at::MemoryFormat::ChannelsLast);
  const torch::Tensor sums = at::conv2d(padded, weight, {}, stride, padding);
  return at::batch_norm(sums, scale_, shift_, mean_, variance_, is_training(), kNormMomentum,
                        kNormEpsilon, true);
}

void ConvNorm::Fold(torch::ScalarType type) {
  const torch::NoGradGuard no_grad;
  const torch::Tensor factor = scale_ / (variance_ + kNormEpsilon).sqrt();
  folded_weight_ =
      (weight_ * factor.view({-1, 1, 1, 1})).to(type).contiguous(at::MemoryFormat::ChannelsLast);
  folded_bias_ = (shift_ - mean_ * factor).to(type);
}

Dense::Dense(int in, int out, sim::Rng* rng, double gain) {
  weight_ = register_parameter("weight", NormalTensor({out, in}, gain * std::sqrt(2.0 / in), rng));
  bias_ = register_parameter("bias", torch::zeros({out}));
}

torch::Tensor Dense::forward(const torch::Tensor& x) {
  return at::linear(x, weight_, bias_);
}

}  // namespace bulletnav::agent
