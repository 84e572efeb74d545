// SPDX-License-Identifier: MIT
#include "benchmark/training/core/adam.h"

#include <charconv>
#include <cmath>

#include "agent/perception/weights.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr double kMeanDecay = 0.9;
constexpr double kVarianceDecay = 0.999;
constexpr const char* kSteps = "adam.steps.";

int StepsIn(const agent::TensorFile& content, const std::string& name,
            const std::filesystem::path& file) {
  const auto found = content.metadata.find(name);
  if (found != content.metadata.end()) {
    const char* end = found->second.data() + found->second.size();
    int steps = 0;
    const auto [stop, error] = std::from_chars(found->second.data(), end, steps);
    if (error == std::errc() && stop == end) return steps;
  }
  throw sim::FileError(file, name, "is missing: remove this checkpoint");
}

torch::Tensor Stored(const agent::TensorFile& content, const std::string& name,
                     const torch::Tensor& like, const std::filesystem::path& file) {
  const auto found = content.tensors.find(name);
  if (found == content.tensors.end() || at::IntArrayRef(found->second.shape) != like.sizes()) {
    throw sim::FileError(file, name, "is missing or of another shape: remove this checkpoint");
  }
  return agent::FromStored(found->second).to(like.device());
}

}  // namespace

Adam::Adam(const torch::nn::Module& module, const OptimiserSpec& spec)
    : weight_decay_(spec.weight_decay), epsilon_(spec.epsilon) {
  for (const auto& item : module.named_parameters()) {
    const torch::Tensor zeros = torch::zeros_like(item.value());
    items_.push_back({item.key(), item.value(), zeros, zeros.clone(), 0});
  }
}

void Adam::Step(double rate) {
  const torch::NoGradGuard no_grad;
  for (Item& item : items_) {
    const torch::Tensor gradient = item.parameter.grad();
    if (!gradient.defined()) continue;
    ++item.steps;
    const double mean_share = 1.0 - sim::Pow(kMeanDecay, item.steps);
    const double deviation_share = std::sqrt(1.0 - sim::Pow(kVarianceDecay, item.steps));
    item.mean.mul_(kMeanDecay).add_(gradient, 1.0 - kMeanDecay);
    item.variance.mul_(kVarianceDecay).addcmul_(gradient, gradient, 1.0 - kVarianceDecay);
    if (weight_decay_ > 0.0) item.parameter.mul_(1.0 - rate * weight_decay_);
    const torch::Tensor deviation = item.variance.sqrt().div_(deviation_share).add_(epsilon_);
    item.parameter.addcdiv_(item.mean, deviation, -rate / mean_share);
    item.parameter.mutable_grad().reset();
  }
}

void Adam::Append(agent::TensorFile* content) const {
  for (const Item& item : items_) {
    content->metadata[kSteps + item.name] = std::to_string(item.steps);
    content->tensors["adam.mean." + item.name] = agent::ToStored(item.mean);
    content->tensors["adam.variance." + item.name] = agent::ToStored(item.variance);
  }
}

void Adam::Set(const agent::TensorFile& content, const std::filesystem::path& file) {
  for (Item& item : items_) {
    item.steps = StepsIn(content, kSteps + item.name, file);
    item.mean = Stored(content, "adam.mean." + item.name, item.mean, file);
    item.variance = Stored(content, "adam.variance." + item.name, item.variance, file);
  }
}

}  // namespace bulletnav::bench
