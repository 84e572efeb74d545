// SPDX-License-Identifier: MIT
// A walk of 10,000 poses along the streets of a town with 50,000 loops where it comes by again.
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "agent/slam/pose_graph/optimize.h"
#include "tests/agent/slam/pose_graph/random_graph.h"

namespace bulletnav::agent {
namespace {

using Place = std::pair<int, int>;

constexpr int kPoses = 10'000;
constexpr int kLoops = 50'000;
constexpr int kTown = 40;         // streets either way, 1 m apart
constexpr double kNoise = 0.005;  // metres and radians

/// Straight on, or a quarter of a turn; never out of town.
std::vector<sim::PlanarPose> Walk(sim::Rng* rng) {
  std::vector<sim::PlanarPose> walk = {{kTown / 2.0, kTown / 2.0, 0.0}};
  walk.reserve(kPoses);
  while (static_cast<int>(walk.size()) < kPoses) {
    const double turn = rng->Chance(0.6) ? 0.0 : rng->Chance(0.5) ? sim::kPi / 2 : -sim::kPi / 2;
    sim::PlanarPose next = Compose(walk.back(), {0.0, 0.0, turn});
    next = Compose(next, {1.0, 0.0, 0.0});
    next.x = std::round(next.x);
    next.y = std::round(next.y);
    if (std::min(next.x, next.y) >= 0.0 && std::max(next.x, next.y) < kTown) walk.push_back(next);
  }
  return walk;
}

template <class Pose>
Pose As(const sim::PlanarPose& pose) {
  if constexpr (kFreedoms<Pose> == 3) {
    return pose;
  } else {
    return InSpace(pose);
  }
}

template <class Pose>
class Town {
 public:
  Town() : walk_(Walk(&rng_)) {
    graph_.vertices.push_back({0, As<Pose>(walk_[0])});
    std::map<Place, std::vector<int>> seen;
    for (int i = 0; i < kPoses; ++i) {
      const sim::PlanarPose& pose = walk_[static_cast<std::size_t>(i)];
      if (i > 0) {
        Join(i - 1, i, false);
        graph_.vertices.push_back(
            {i, Compose(graph_.vertices.back().pose, graph_.edges.back().measured)});
      }
      seen[{static_cast<int>(pose.x), static_cast<int>(pose.y)}].push_back(i);
    }
    while (static_cast<int>(graph_.edges.size()) < kPoses - 1 + kLoops) {
      const int to = rng_.Below(kPoses);
      const sim::PlanarPose& pose = walk_[static_cast<std::size_t>(to)];
      const Place near = {static_cast<int>(pose.x) + rng_.Between(-1, 1),
                          static_cast<int>(pose.y) + rng_.Between(-1, 1)};
      const auto there = seen.find(near);
      if (there == seen.end()) continue;
      const int from = rng_.Pick(there->second);
      if (from + 10 < to) Join(from, to, true);
    }
  }

  const PoseGraph<Pose>& graph() const { return graph_; }

 private:
  void Join(int from, int to, bool is_loop) {
    const Pose seen = As<Pose>(Compose(Inverse(walk_[static_cast<std::size_t>(from)]),
                                       walk_[static_cast<std::size_t>(to)]));
    graph_.edges.push_back({from, to, tests::Moved(seen, tests::RandomNumbers<Pose>(kNoise, &rng_)),
                            PoseMatrix<Pose>::Identity() / (kNoise * kNoise), is_loop});
  }

  sim::Rng rng_{1, "town"};
  std::vector<sim::PlanarPose> walk_;
  PoseGraph<Pose> graph_;
};

template <class Pose>
void OptimizeTown(benchmark::State& state) {
  const Town<Pose> town;
  OptimizeSummary summary;
  for (auto _ : state) {
    auto graph = town.graph();
    summary = Optimize({.kernel = RobustKernel::kHuber}, &graph);
  }
  state.counters["iterations"] = summary.iterations;
  state.counters["converged"] = summary.converged ? 1 : 0;
  state.counters["initial_cost"] = summary.initial_cost;
  state.counters["final_cost"] = summary.final_cost;
}
BENCHMARK(OptimizeTown<sim::PlanarPose>)->Unit(benchmark::kMillisecond);
BENCHMARK(OptimizeTown<SpatialPose>)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bulletnav::agent

BENCHMARK_MAIN();
