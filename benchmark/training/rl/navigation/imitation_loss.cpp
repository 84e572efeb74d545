// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/imitation_loss.h"

#include "benchmark/training/rl/rollout.h"
#include "sim/base/action.h"

namespace bulletnav::bench {
namespace {

constexpr double kLeastWeight = 1e-6;  // instead of none at all

torch::Tensor Mean(const torch::Tensor& sum, const torch::Tensor& weights) {
  return sum / weights.sum().clamp_min(kLeastWeight);
}

}  // namespace

ImitationLoss ImitationLossOf(const torch::Tensor& log_probabilities, const torch::Tensor& lessons,
                              const LessonWeights& weights) {
  const torch::Tensor count = (lessons != kNoLesson).to(torch::kFloat32);
  const auto are = [&](sim::Action action) {
    return (lessons == static_cast<int>(action)).to(torch::kFloat32);
  };
  const torch::Tensor weight = count + (weights.stop - 1.0) * are(sim::Action::kStop) +
                               (weights.forward - 1.0) * are(sim::Action::kMoveForward);
  const torch::Tensor right =
      log_probabilities.gather(-1, lessons.clamp_min(0).unsqueeze(-1)).squeeze(-1);
  const torch::Tensor agreed = (log_probabilities.argmax(-1) == lessons).to(torch::kFloat32);
  return {-Mean((right * weight).sum(), weight), Mean(agreed.sum(), count).item<double>()};
}

}  // namespace bulletnav::bench
