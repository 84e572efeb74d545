// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/goal_net.h"

#include "benchmark/training/rl/exploration/exploration_lanes.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {
namespace {

constexpr double kHalfLogTwoPi = 0.91893853320467274178;
constexpr std::int64_t kSide = 8192;  // see ActionOf
constexpr std::int64_t kMiddle = 4096;

}  // namespace

GoalNet::GoalNet(const agent::ExplorationConfig& config, bool learns_deviation, std::uint64_t seed)
    : learns_deviation_(learns_deviation),
      net_(register_module("policy", std::make_shared<agent::ExplorationNet>(config, seed))) {}

GoalNet::Output GoalNet::Run(const Seen& seen, const torch::Tensor& /*starts*/,
                             const torch::Tensor& hidden) {
  const agent::ExplorationNet::Output answer = net_->Answer(seen.codes, seen.numbers.squeeze(-1));
  const torch::Tensor& own = net_->log_deviation();
  const torch::Tensor deviation = learns_deviation_ ? own : own.detach();
  return {at::cat({answer.means, deviation.expand_as(answer.means)}, -1), answer.values, hidden};
}

int GoalNet::Draw(std::span<const float> said, sim::Rng* rng) const {
  agent::GoalDistribution goal;
  for (std::size_t i = 0; i < goal.mean.size(); ++i) {
    goal.mean[i] = double{said[i]};
    goal.deviation[i] = sim::Exp(double{said[2 + i]});
  }
  return ActionOf(agent::DrawGoal(goal, rng));
}

/// Densities of the numbers that goals were rounded from.
torch::Tensor GoalNet::LogProbabilitiesOf(const Output& output,
                                          const torch::Tensor& actions) const {
  const torch::Tensor first = actions.div(kSide, "floor");
  const torch::Tensor numbers =
      (at::stack({first, actions - first * kSide}, -1) - kMiddle).to(torch::kFloat32) *
      agent::kGoalStep;
  const torch::Tensor mean = output.log_probabilities.narrow(-1, 0, 2);
  const torch::Tensor log_deviation = output.log_probabilities.narrow(-1, 2, 2);
  const torch::Tensor off = (numbers - mean) / log_deviation.exp();
  return (-0.5 * off.square() - log_deviation - kHalfLogTwoPi).sum(-1);
}

torch::Tensor GoalNet::EntropyOf(const Output& output) const {
  return (output.log_probabilities.narrow(-1, 2, 2) + (0.5 + kHalfLogTwoPi)).sum(-1);
}

void GoalNet::SetDeviation(double deviation) {
  const torch::NoGradGuard no_grad;
  torch::Tensor(net_->log_deviation()).fill_(sim::Log(deviation));
}

}  // namespace bulletnav::bench
