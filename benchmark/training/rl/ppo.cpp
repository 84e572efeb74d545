// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/ppo.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/core.h>

#include "sim/config/yaml_reader.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr int kMostLanes = 4096;
constexpr int kMostSteps = 65536;

struct Targets {
  torch::Tensor advantages;  // [steps, lanes], of mean 0 and variance 1
  torch::Tensor returns;     // [steps, lanes], normalised
  double explained_variance = 0.0;
};

double VarianceOf(const std::vector<double>& numbers) {
  RunningMoments moments;
  moments.Add(numbers);
  return moments.squares / moments.count;
}

/// [lanes * steps], lane after lane, as a tensor [steps, lanes].
torch::Tensor ByStep(const std::vector<double>& numbers, std::size_t lanes) {
  const auto rows = static_cast<std::int64_t>(lanes);
  return at::tensor(numbers).to(torch::kFloat32).view({rows, -1}).t().contiguous();
}

/// Mean, variance and moments are of the lanes of all processes.
Targets TargetsOf(const Rollout& rollout, const GaeSpec& spec, LaneGroups* groups,
                  RunningMoments* moments) {
  std::vector<double> advantages, returns;
  const std::size_t size = rollout.steps.size() * rollout.steps.front().size();
  advantages.reserve(size);
  returns.reserve(size);
  for (std::size_t lane = 0; lane < rollout.steps.size(); ++lane) {
    const std::vector<LaneStep>& steps = rollout.steps[lane];
    std::vector<double> of_lane(steps.size());
    EstimateAdvantages(spec, steps, rollout.last_values[lane], of_lane);
    for (std::size_t t = 0; t < steps.size(); ++t) {
      advantages.push_back(of_lane[t]);
      returns.push_back(of_lane[t] + steps[t].value);
    }
  }
  Targets targets;
  const std::vector<double> all_returns = groups->Gather(returns);
  const std::vector<double> all_advantages = groups->Gather(advantages);
  const double variance = VarianceOf(all_returns);
  if (variance > 0.0) targets.explained_variance = 1.0 - VarianceOf(all_advantages) / variance;
  moments->Add(all_returns);
  RunningMoments scale;
  scale.Add(all_advantages);
  targets.advantages = (ByStep(advantages, rollout.steps.size()) - scale.mean) / scale.deviation();
  targets.returns = (ByStep(returns, rollout.steps.size()) - moments->mean) / moments->deviation();
  return targets;
}

/// The loss of some lanes, and how they fared.
torch::Tensor LossOf(const Rollout& rollout, const Targets& targets, const torch::Tensor& lanes,
                     const PpoSpec& spec, ActorCritic* net, PpoReport* report) {
  const auto of = [&](const torch::Tensor& all) {
    return all.index_select(1, lanes);
  };
  const ActorCritic::Output output = net->Run(rollout.SeenBy(net, lanes), of(rollout.starts),
                                              rollout.hidden.index_select(0, lanes));
  const torch::Tensor log_probability = net->LogProbabilitiesOf(output, of(rollout.actions));
  const torch::Tensor log_ratio = log_probability - of(rollout.log_probabilities);
  const torch::Tensor ratio = log_ratio.exp();
  const torch::Tensor advantages = of(targets.advantages);
  const torch::Tensor gain =
      at::minimum(ratio * advantages, ratio.clamp(1.0 - spec.clip, 1.0 + spec.clip) * advantages);
  const torch::Tensor value_error = (output.values - of(targets.returns)).square().mean();
  const torch::Tensor entropy = net->EntropyOf(output).mean();
  report->entropy = entropy.item<double>();
  report->kl = (ratio - 1.0 - log_ratio).mean().item<double>();
  const torch::Tensor off = (ratio - 1.0).abs();
  report->clip_fraction = (off > spec.clip).to(torch::kFloat32).mean().item<double>();
  report->first_ratio_error = off.mean().item<double>();
  return -gain.mean() + spec.value * 0.5 * value_error - spec.entropy * entropy;
}

/// Without a gradient, parameters stay as they are, and the optimiser has not seen them yet.
void KeepValueGradients(ActorCritic* net) {
  for (const auto& parameter : net->named_parameters()) {
    torch::Tensor& gradient = parameter.value().mutable_grad();
    if (gradient.defined() && !ActorCritic::IsOfValue(parameter.key())) gradient.reset();
  }
}

constexpr std::size_t kNumbers = 4;  // of a group's report

std::array<double, kNumbers> NumbersOf(const PpoReport& report) {
  return {report.entropy, report.kl, report.clip_fraction, report.first_ratio_error};
}

/// Means over groups; `numbers` of each.
PpoReport MeanOf(const std::vector<double>& numbers, const std::vector<double>& losses) {
  PpoReport mean;
  const auto count = static_cast<double>(losses.size());
  for (std::size_t i = 0; i < losses.size(); ++i) {
    mean.loss += losses[i] / count;
    mean.entropy += numbers[kNumbers * i] / count;
    mean.kl += numbers[kNumbers * i + 1] / count;
    mean.clip_fraction += numbers[kNumbers * i + 2] / count;
    mean.first_ratio_error += numbers[kNumbers * i + 3] / count;
  }
  return mean;
}

}  // namespace

void PpoSpec::Validate() const {
  if (lanes < 1 || lanes > kMostLanes) {
    throw sim::KeyError("lanes", fmt::format("lanes must lie between 1 and {}", kMostLanes));
  }
  if (rollout < 1 || rollout > kMostSteps) {
    throw sim::KeyError("rollout", fmt::format("rollout must lie between 1 and {}", kMostSteps));
  }
  if (epochs < 1) throw sim::KeyError("epochs", "epochs must be at least 1");
  RequireGroups(lanes, group, minibatches);
  if (!(clip > 0.0)) throw sim::KeyError("clip", "clip must be positive");
  constexpr double kMostWeight = 100.0;
  for (const auto& [key, weight] : {std::pair{"entropy", entropy}, std::pair{"value", value}}) {
    if (weight >= 0.0 && weight <= kMostWeight) continue;
    throw sim::KeyError(key, std::string(key) + " must lie between 0 and 100");
  }
  if (!(gradient_norm > 0.0)) {
    throw sim::KeyError("gradient_norm", "gradient_norm must be positive");
  }
  if (value_first < 0) throw sim::KeyError("value_first", "value_first must not be negative");
}

PpoReport LearnFrom(const Rollout& rollout, const PpoSpec& spec, const PpoStep& step,
                    LaneGroups* groups, ActorCritic* net, RunningMoments* moments) {
  const Targets targets = TargetsOf(rollout, spec.gae, groups, moments);
  const int updates = spec.epochs * spec.minibatches;
  PpoReport mean;
  mean.explained_variance = targets.explained_variance;
  std::vector<std::vector<int>> minibatches;
  for (int i = 0; i < updates; ++i) {
    const int part = i % spec.minibatches;
    if (part == 0) {
      sim::Rng rng = sim::Rng(step.seed, "lanes").Fork("epoch", static_cast<std::uint64_t>(i));
      minibatches = DrawMinibatches(groups->groups(), spec.minibatches, &rng);
    }
    const std::vector<int>& chosen = minibatches[static_cast<std::size_t>(part)];
    std::vector<PpoReport> reports(static_cast<std::size_t>(groups->groups()));
    const std::vector<double> losses =
        groups->Differentiate(chosen, [&](int group, ActorCritic* own) {
          return LossOf(rollout, targets, groups->LanesOf(group), spec, own,
                        &reports[static_cast<std::size_t>(group)]);
        });
    std::vector<double> numbers;
    for (const int group : groups->Own(chosen)) {
      const auto of_group = NumbersOf(reports[static_cast<std::size_t>(group)]);
      numbers.insert(numbers.end(), of_group.begin(), of_group.end());
    }
    const PpoReport report = MeanOf(groups->Gather(numbers), losses);
    if (step.value_alone) KeepValueGradients(net);
    LimitGradients(*net, spec.gradient_norm);
    step.optimiser->Step(step.rate);
    mean.loss += report.loss / updates;
    mean.entropy += report.entropy / updates;
    mean.kl += report.kl / updates;
    mean.clip_fraction += report.clip_fraction / updates;
    if (i > 0) continue;
    mean.first_ratio_error = report.first_ratio_error;
    mean.first_clip_fraction = report.clip_fraction;
  }
  return mean;
}

}  // namespace bulletnav::bench
