// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/exploration_validation.h"

#include <algorithm>

#include "agent/policy/exploration_view.h"

namespace bulletnav::bench {

ExplorationValidation::ExplorationValidation(const ExplorationScenes* scenes,
                                             const MapSimulatorSpec& spec, int episodes)
    : scenes_(scenes), spec_(spec), episodes_(episodes) {}

ExplorationValidation::Result ExplorationValidation::Play(
    int number, agent::ExplorationPolicy* policy,
    const std::function<void(std::span<const std::uint8_t>)>& saw) const {
  const auto episode = static_cast<std::uint64_t>(number);
  const ExplorationScenes::Drawn drawn = scenes_->DrawInTurn(episode);
  MapSimulator simulator(spec_);
  simulator.Begin(*drawn.scene, drawn.start, drawn.seed);
  sim::Rng rng = sim::Rng(drawn.seed, "validation").Fork("episode", episode);
  std::vector<std::uint8_t> view(agent::kExplorationBytes);
  while (!simulator.is_over()) {
    if (policy == nullptr) {
      simulator.Walk(agent::DrawAnyGoal(&rng));
      continue;
    }
    simulator.Show(view);
    if (saw) saw(view);
    simulator.Walk(agent::DrawGoal(policy->Ask(view, simulator.heading()), &rng));
  }
  return {simulator.explored(), static_cast<double>(simulator.collisions())};
}

ExplorationValidation::Result ExplorationValidation::Measure(const PolicyMaker& make,
                                                             sim::WorkerPool* pool) const {
  std::vector<Result> results(static_cast<std::size_t>(episodes_));
  pool->ForEach(episodes_, [&](int i, int) {
    const std::shared_ptr<agent::ExplorationPolicy> policy = make();
    results[static_cast<std::size_t>(i)] = Play(i, policy.get(), {});
  });
  Result mean;
  for (const Result& result : results) {
    mean.explored += result.explored / episodes_;
    mean.collisions += result.collisions / episodes_;
  }
  return mean;
}

std::vector<std::uint8_t> ExplorationValidation::Views(const PolicyMaker& make,
                                                       int episodes) const {
  const std::shared_ptr<agent::ExplorationPolicy> policy = make();
  std::vector<std::uint8_t> views;
  for (int i = 0; i < std::min(episodes, episodes_); ++i) {
    Play(i, policy.get(), [&](std::span<const std::uint8_t> view) {
      views.insert(views.end(), view.begin(), view.end());
    });
  }
  return views;
}

}  // namespace bulletnav::bench
