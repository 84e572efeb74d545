// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/rollout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

int SampleAction(const ActionKey& key, std::span<const float> log_probabilities) {
  std::vector<double> weights(log_probabilities.size());
  std::transform(log_probabilities.begin(), log_probabilities.end(), weights.begin(),
                 [](float value) {
                   return sim::Exp(double{value});
                 });
  sim::Rng rng = sim::Rng(key.seed, "action")
                     .Fork("lane", static_cast<std::uint64_t>(key.lane))
                     .Fork("episode", key.episode)
                     .Fork("step", key.step);
  return static_cast<int>(rng.Weighted(weights));
}

Actor::Actor(PolicyTask* task, PolicyNet* net, std::uint64_t seed)
    : task_(task),
      net_(net),
      seed_(seed),
      hidden_(net->NoMemory(task->lanes())),
      starts_(torch::ones({task->lanes()})),
      episodes_(static_cast<std::size_t>(task->lanes())),
      steps_(episodes_.size()) {
  for (int lane = 0; lane < task->lanes(); ++lane) task->Begin(lane, 0);
}

torch::Tensor Actor::Observed() const {
  torch::Tensor observed = torch::empty({1, task_->lanes(), task_->observation_size()});
  task_->Observe({observed.data_ptr<float>(), static_cast<std::size_t>(observed.numel())});
  return observed;
}

Rollout Actor::Play(int steps, const RunningMoments& moments) {
  const torch::NoGradGuard no_grad;
  const std::size_t lanes = episodes_.size();
  Rollout rollout;
  rollout.hidden = hidden_.clone();
  rollout.steps.resize(lanes);
  std::vector<torch::Tensor> observations, starts, chosen, log_probabilities;
  for (auto* of_steps : {&observations, &starts, &chosen, &log_probabilities}) {
    of_steps->reserve(static_cast<std::size_t>(steps));
  }
  rollout.first_scores.reserve(lanes);
  std::vector<int> actions(lanes);
  std::vector<LaneOutcome> outcomes(lanes);
  for (int t = 0; t < steps; ++t) {
    observations.push_back(Observed());
    starts.push_back(starts_.unsqueeze(0));
    const PolicyNet::Output output = net_->Run(observations.back(), starts.back(), hidden_);
    hidden_ = output.hidden;
    starts_ = torch::zeros_like(starts_);
    Act(output, &actions);
    chosen.push_back(
        at::tensor(std::vector<std::int64_t>(actions.begin(), actions.end())).unsqueeze(0));
    log_probabilities.push_back(
        output.log_probabilities.gather(-1, chosen.back().unsqueeze(-1)).squeeze(-1));
    task_->Step(actions, outcomes);
    const bool has_cut =
        std::any_of(outcomes.begin(), outcomes.end(), [](const LaneOutcome& outcome) {
          return outcome.truncated;
        });
    std::vector<double> cut_values(lanes);
    if (has_cut) cut_values = ValuesHere(starts_, moments);
    for (std::size_t i = 0; i < lanes; ++i) {
      const double value = output.values[0][static_cast<std::int64_t>(i)].item<double>();
      rollout.steps[i].push_back({outcomes[i].reward, value * moments.deviation() + moments.mean,
                                  outcomes[i].terminated, outcomes[i].truncated, cut_values[i]});
      if ((outcomes[i].terminated || outcomes[i].truncated) && episodes_[i] == 0) {
        rollout.first_scores.push_back(outcomes[i].score);
      }
    }
    BeginOver(outcomes);
  }
  rollout.observations = at::cat(observations);
  rollout.starts = at::cat(starts);
  rollout.actions = at::cat(chosen);
  rollout.log_probabilities = at::cat(log_probabilities);
  rollout.last_values = ValuesHere(starts_, moments);
  return rollout;
}

void Actor::Act(const PolicyNet::Output& output, std::vector<int>* actions) const {
  const auto count = static_cast<std::size_t>(task_->actions());
  const torch::Tensor flat = output.log_probabilities.contiguous();
  for (std::size_t i = 0; i < actions->size(); ++i) {
    (*actions)[i] = SampleAction({seed_, static_cast<int>(i), episodes_[i], steps_[i]},
                                 {flat.data_ptr<float>() + i * count, count});
  }
}

std::vector<double> Actor::ValuesHere(const torch::Tensor& starts, const RunningMoments& moments) {
  const torch::Tensor values = net_->Run(Observed(), starts.unsqueeze(0), hidden_).values[0];
  std::vector<double> all(episodes_.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] =
        values[static_cast<std::int64_t>(i)].item<double>() * moments.deviation() + moments.mean;
  }
  return all;
}

void Actor::BeginOver(const std::vector<LaneOutcome>& outcomes) {
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    ++steps_[i];
    if (!outcomes[i].terminated && !outcomes[i].truncated) continue;
    task_->Begin(static_cast<int>(i), ++episodes_[i]);
    steps_[i] = 0;
    starts_[static_cast<std::int64_t>(i)] = 1.0;
  }
}

std::vector<float> Actor::State() const {
  std::vector<float> state;
  state.reserve(3 * episodes_.size());
  for (std::size_t i = 0; i < episodes_.size(); ++i) {
    state.push_back(static_cast<float>(episodes_[i]));
    state.push_back(static_cast<float>(steps_[i]));
    state.push_back(starts_[static_cast<std::int64_t>(i)].item<float>());
  }
  return state;
}

void Actor::SetState(const std::vector<float>& state, const torch::Tensor& hidden) {
  BULLETNAV_CHECK(state.size() == 3 * episodes_.size());
  for (std::size_t i = 0; i < episodes_.size(); ++i) {
    episodes_[i] = static_cast<std::uint64_t>(state[3 * i]);
    steps_[i] = static_cast<std::uint64_t>(state[3 * i + 1]);
    starts_[static_cast<std::int64_t>(i)] = state[3 * i + 2];
  }
  hidden_ = hidden.clone();
}

}  // namespace bulletnav::bench
