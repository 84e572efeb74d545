// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/ppo.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "sim/config/yaml_reader.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

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

Targets TargetsOf(const Rollout& rollout, const GaeSpec& spec, RunningMoments* moments) {
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
  const double variance = VarianceOf(returns);
  if (variance > 0.0) targets.explained_variance = 1.0 - VarianceOf(advantages) / variance;
  moments->Add(returns);
  RunningMoments scale;
  scale.Add(advantages);
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

/// Means over groups.
PpoReport MeanOf(const std::vector<PpoReport>& parts, const std::vector<double>& losses) {
  PpoReport mean;
  const auto count = static_cast<double>(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    mean.loss += losses[i] / count;
    mean.entropy += parts[i].entropy / count;
    mean.kl += parts[i].kl / count;
    mean.clip_fraction += parts[i].clip_fraction / count;
    mean.first_ratio_error += parts[i].first_ratio_error / count;
  }
  return mean;
}

}  // namespace

void PpoSpec::Validate() const {
  if (lanes < 1) throw sim::KeyError("lanes", "lanes must be at least 1");
  if (rollout < 1) throw sim::KeyError("rollout", "rollout must be at least 1");
  if (epochs < 1) throw sim::KeyError("epochs", "epochs must be at least 1");
  if (group < 1 || lanes % group != 0) throw sim::KeyError("group", "group must divide lanes");
  if (minibatches < 1 || lanes / group % minibatches != 0) {
    throw sim::KeyError("minibatches",
                        "minibatches must divide the number of groups, lanes / group");
  }
  if (!(clip > 0.0)) throw sim::KeyError("clip", "clip must be positive");
  if (!(gradient_norm > 0.0)) {
    throw sim::KeyError("gradient_norm", "gradient_norm must be positive");
  }
}

PpoReport LearnFrom(const Rollout& rollout, const PpoSpec& spec, const PpoStep& step,
                    LaneGroups* groups, ActorCritic* net, RunningMoments* moments) {
  const Targets targets = TargetsOf(rollout, spec.gae, moments);
  std::vector<int> order(static_cast<std::size_t>(groups->groups()));
  std::iota(order.begin(), order.end(), 0);
  const std::size_t size = order.size() / static_cast<std::size_t>(spec.minibatches);
  const int updates = spec.epochs * spec.minibatches;
  PpoReport mean;
  mean.explained_variance = targets.explained_variance;
  for (int i = 0; i < updates; ++i) {
    const int part = i % spec.minibatches;
    if (part == 0) {
      sim::Rng rng = sim::Rng(step.seed, "lanes").Fork("epoch", static_cast<std::uint64_t>(i));
      rng.Shuffle(order);
    }
    const auto first = order.begin() + static_cast<std::ptrdiff_t>(size) * part;
    const std::vector<int> chosen(first, first + static_cast<std::ptrdiff_t>(size));
    std::vector<PpoReport> reports(static_cast<std::size_t>(groups->groups()));
    const std::vector<double> losses =
        groups->Differentiate(chosen, [&](int group, ActorCritic* own) {
          return LossOf(rollout, targets, groups->LanesOf(group), spec, own,
                        &reports[static_cast<std::size_t>(group)]);
        });
    std::vector<PpoReport> in_order;
    in_order.reserve(chosen.size());
    for (const int group : chosen) in_order.push_back(reports[static_cast<std::size_t>(group)]);
    const PpoReport report = MeanOf(in_order, losses);
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
