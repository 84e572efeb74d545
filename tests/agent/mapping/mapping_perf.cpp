// SPDX-License-Identifier: MIT
// What a step of metric_map_fbe costs without the simulator, and its parts, in the shell of a
// house.
#include <array>
#include <memory>

#include <benchmark/benchmark.h>

#include "agent/mapping/map_navigator.h"
#include "agent/models/goal_estimator.h"
#include "agent/registry.h"
#include "sim/simulator.h"
#include "tests/support/houses.h"
#include "tests/support/trials.h"

namespace bulletnav::agent {
namespace {

constexpr int kSteps = 300;

/// Never sees the goal, so that the agent goes on exploring.
class Blindfold final : public GoalEstimator {
 public:
  std::optional<RelativeGoal> Estimate(const Panorama& /*here*/,
                                       const Panorama& /*goal*/) override {
    return std::nullopt;
  }
};

std::unique_ptr<BatchAgent> Explorer() {
  Rig rig;
  rig.has_color = false;
  std::array contexts = {AgentContext{rig}};
  contexts[0].models.Set("semantic_model", std::make_shared<Blindfold>());
  auto agent = ConfigureAgent("metric_map_fbe")(contexts);
  agent->Reset(0, {}, 1);
  return agent;
}

sim::Action Act(const sim::Observation& seen, int step, BatchAgent* agent) {
  std::array actions = {sim::Action::kStop};
  agent->Act(std::array{LaneObservation{0, View(seen, step)}}, actions);
  return actions[0];
}

/// What the agent sees while it explores; the same observations lead it the same way again.
const std::vector<sim::Observation>& Walk() {
  static const std::vector<sim::Observation> walk = [] {
    const auto world = sim::World::FromMesh(tests::ShellHouse(1), "house");
    sim::SimulatorSpec spec;
    spec.color = false;
    sim::Simulator simulator(world, spec);
    sim::Rng rng(1, "perf");
    const tests::Trial trial = tests::DrawTrial(world, 5.0, 10.0, &rng);
    const auto agent = Explorer();
    std::vector<sim::Observation> seen = {simulator.Reset(trial.start, trial.key)};
    for (int step = 0; step < kSteps; ++step) {
      seen.push_back(simulator.Step(Act(seen.back(), step, agent.get())));
    }
    return seen;
  }();
  return walk;
}

/// A navigator after the whole walk.
MapNavigator Experienced() {
  MapNavigator navigator({}, {});
  navigator.Reset();
  for (int step = 0; step < kSteps; ++step) {
    navigator.Observe(View(Walk()[static_cast<std::size_t>(step)], step));
  }
  return navigator;
}

void WholeStep(benchmark::State& state) {
  const auto& walk = Walk();
  auto agent = Explorer();
  int step = 0;
  for (auto _ : state) {
    if (step == kSteps) {
      agent->Reset(0, {}, 1);
      step = 0;
    }
    benchmark::DoNotOptimize(Act(walk[static_cast<std::size_t>(step)], step, agent.get()));
    ++step;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(WholeStep)->Unit(benchmark::kMicrosecond)->Iterations(2 * kSteps);

void MatchScans(benchmark::State& state) {
  const auto& walk = Walk();
  ScanMatch match(Rig{});
  std::size_t step = 0;
  for (auto _ : state) {
    const Observation seen = View(walk[step % walk.size()], 0);
    benchmark::DoNotOptimize(match.Match(seen.panorama, seen.odometry));
    ++step;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(MatchScans)->Unit(benchmark::kMicrosecond);

void MapUpdate(benchmark::State& state) {
  MetricMap map({}, {});
  const auto& depth = Walk()[kSteps / 2].depth;
  for (auto _ : state) map.Update({{}, depth}, {});
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(MapUpdate)->Unit(benchmark::kMicrosecond);

void PlanAcrossTheMap(benchmark::State& state) {
  MapNavigator navigator = Experienced();
  for (auto _ : state) benchmark::DoNotOptimize(navigator.Plan({0.0, 0.0}, false));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(PlanAcrossTheMap)->Unit(benchmark::kMicrosecond);

void WholeDistanceField(benchmark::State& state) {
  const MapNavigator navigator = Experienced();
  const sim::Grid<sim::CellState>& states = navigator.map().states();
  sim::FastMarching march(states.size());
  std::int64_t cells = 0;
  for (auto _ : state) {
    march.Start(states, {navigator.map().CellAt(navigator.here())});
    while (march.Next()) ++cells;
  }
  state.SetItemsProcessed(cells);
}
BENCHMARK(WholeDistanceField)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bulletnav::agent

BENCHMARK_MAIN();
