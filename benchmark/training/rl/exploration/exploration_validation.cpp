// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/exploration_validation.h"

#include <algorithm>

#include "agent/policy/exploration_view.h"

namespace bulletnav::bench {

ExplorationValidation::ExplorationValidation(const ExplorationScenes* scenes,
                                             const MapSimulatorSpec& spec, int episodes)
    : scenes_(scenes), spec_(spec), episodes_(episodes) {}

ExplorationValidation::Result ExplorationValidation::Play(int number, const Walk& walk) const {
  const auto episode = static_cast<std::uint64_t>(number);
  const ExplorationScenes::Drawn drawn = scenes_->DrawInTurn(episode);
  MapSimulator simulator(spec_);
  simulator.Begin(*drawn.scene, drawn.start, drawn.seed);
  sim::Rng rng = sim::Rng(drawn.seed, "validation").Fork("episode", episode);
  double early = 0.0;
  while (!simulator.is_over()) {
    walk(&simulator, &rng);
    if (4 * simulator.steps() <= spec_.episode_steps) early = simulator.worth();
  }
  return {simulator.explored(), early, static_cast<double>(simulator.collisions())};
}

ExplorationValidation::Result ExplorationValidation::MeanOf(const std::function<Walk()>& make,
                                                            sim::WorkerPool* pool) const {
  std::vector<Result> results(static_cast<std::size_t>(episodes_));
  pool->ForEach(episodes_, [&](int i, int) {
    results[static_cast<std::size_t>(i)] = Play(i, make());
  });
  Result mean;
  for (const Result& result : results) {
    mean.explored += result.explored / episodes_;
    mean.early += result.early / episodes_;
    mean.collisions += result.collisions / episodes_;
  }
  return mean;
}

ExplorationValidation::Result ExplorationValidation::Measure(const PolicyMaker& make,
                                                             sim::WorkerPool* pool) const {
  return MeanOf(
      [&make]() -> Walk {
        return [policy = make()](MapSimulator* simulator, sim::Rng* rng) {
          std::vector<std::uint8_t> view(agent::kExplorationBytes);
          simulator->Show(view);
          simulator->Walk(agent::DrawGoal(policy->Ask(view, simulator->heading()), rng));
        };
      },
      pool);
}

ExplorationValidation::Result ExplorationValidation::MeasureRandomGoals(
    sim::WorkerPool* pool) const {
  return MeanOf(
      [] {
        return [](MapSimulator* simulator, sim::Rng* rng) {
          simulator->Walk(agent::DrawAnyGoal(rng));
        };
      },
      pool);
}

ExplorationValidation::Result ExplorationValidation::MeasureFrontiers(sim::WorkerPool* pool) const {
  return MeanOf(
      [] {
        return [](MapSimulator* simulator, sim::Rng* /*rng*/) {
          simulator->WalkToFrontiers();
        };
      },
      pool);
}

std::vector<std::uint8_t> ExplorationValidation::Views(const PolicyMaker& make,
                                                       int episodes) const {
  const std::shared_ptr<agent::ExplorationPolicy> policy = make();
  std::vector<std::uint8_t> views;
  std::vector<std::uint8_t> view(agent::kExplorationBytes);
  for (int i = 0; i < std::min(episodes, episodes_); ++i) {
    Play(i, [&](MapSimulator* simulator, sim::Rng* rng) {
      simulator->Show(view);
      views.insert(views.end(), view.begin(), view.end());
      simulator->Walk(agent::DrawGoal(policy->Ask(view, simulator->heading()), rng));
    });
  }
  return views;
}

}  // namespace bulletnav::bench
