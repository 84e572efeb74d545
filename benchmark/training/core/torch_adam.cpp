// SPDX-License-Identifier: MIT
#include <memory>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <torch/optim/adam.h>

#include "agent/models/safetensors.h"
#include "agent/perception/weights.h"
#include "benchmark/training/core/optimiser.h"
#include "benchmark/training/core/train_plan.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kSteps = "torch_adam.steps.";
constexpr const char* kMean = "torch_adam.mean.";
constexpr const char* kVariance = "torch_adam.variance.";

using State = torch::optim::AdamParamState;

/// By which torch finds a parameter's state: its address, as text in older versions.
template <class States>
typename States::key_type KeyOf(const States& /*states*/, const torch::Tensor& parameter) {
  if constexpr (std::is_same_v<typename States::key_type, std::string>) {
    std::ostringstream text;
    text << parameter.unsafeGetTensorImpl();
    return text.str();
  } else {
    return parameter.unsafeGetTensorImpl();
  }
}

class TorchAdam final : public Optimiser {
 public:
  TorchAdam(const torch::nn::Module& net, const OptimiserSpec& spec)
      : adam_(net.parameters(),
              torch::optim::AdamOptions().weight_decay(spec.weight_decay).eps(spec.epsilon)) {
    for (const auto& item : net.named_parameters()) named_.emplace_back(item.key(), item.value());
  }

  void Step(double rate) override {
    for (auto& group : adam_.param_groups()) group.options().set_lr(rate);
    adam_.step();
    adam_.zero_grad();
  }

  void Append(agent::TensorFile* content) const override {
    for (const auto& [name, parameter] : named_) {
      const auto found = adam_.state().find(KeyOf(adam_.state(), parameter));
      if (found == adam_.state().end()) continue;  // has had no gradient yet
      const auto& state = static_cast<const State&>(*found->second);
      content->metadata[kSteps + name] = std::to_string(state.step());
      content->tensors[kMean + name] = agent::ToStored(state.exp_avg());
      content->tensors[kVariance + name] = agent::ToStored(state.exp_avg_sq());
    }
  }

  void Set(const agent::TensorFile& content, const std::filesystem::path& file) override {
    adam_.state().clear();
    for (const auto& [name, parameter] : named_) {
      const auto steps = content.metadata.find(kSteps + name);
      if (steps == content.metadata.end()) continue;
      auto state = std::make_unique<State>();
      state->step(std::stoll(steps->second));
      state->exp_avg(Stored(content, kMean + name, parameter, file));
      state->exp_avg_sq(Stored(content, kVariance + name, parameter, file));
      adam_.state()[KeyOf(adam_.state(), parameter)] = std::move(state);
    }
  }

 private:
  static torch::Tensor Stored(const agent::TensorFile& content, const std::string& name,
                              const torch::Tensor& like, const std::filesystem::path& file) {
    const auto found = content.tensors.find(name);
    if (found == content.tensors.end() || at::IntArrayRef(found->second.shape) != like.sizes()) {
      throw sim::FileError(file, name, "is missing or of another shape: remove this checkpoint");
    }
    return agent::FromStored(found->second).to(like.device());
  }

  torch::optim::Adam adam_;
  std::vector<std::pair<std::string, torch::Tensor>> named_;
};

}  // namespace

std::unique_ptr<Optimiser> MakeTorchAdam(const torch::nn::Module& net, const OptimiserSpec& spec) {
  return std::make_unique<TorchAdam>(net, spec);
}

}  // namespace bulletnav::bench
