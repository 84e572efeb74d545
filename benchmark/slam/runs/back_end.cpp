// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/back_end.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "agent/slam/pose_graph/loop_sets.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using Information = agent::PoseMatrix<sim::PlanarPose>;

Information Covariance(double metres, double degrees) {
  const double yaw = sim::DegToRad(degrees);
  return Eigen::Vector3d(metres * metres, metres * metres, yaw * yaw).asDiagonal();
}

agent::PoseEdge<sim::PlanarPose> EdgeOf(const MeasuredLoop& loop, const BackEndSpec& spec) {
  agent::PoseEdge<sim::PlanarPose> edge;
  edge.from = loop.earlier;
  edge.to = loop.later;
  edge.measured = loop.motion;
  edge.information = Covariance(spec.loop_m, spec.loop_deg).inverse();
  edge.is_loop = true;
  return edge;
}

std::vector<sim::PlanarPose> StepsOf(std::span<const sim::PlanarPose> odometry) {
  std::vector<sim::PlanarPose> steps;
  steps.reserve(odometry.size());
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    steps.push_back(sim::Compose(sim::Inverse(odometry[i - 1]), odometry[i]));
  }
  return steps;
}

using Edges = std::vector<agent::PoseEdge<sim::PlanarPose>>;
using Chain = agent::OdometryChain<sim::PlanarPose>;

Chain ChainOf(const std::vector<sim::PlanarPose>& steps, const BackEndSpec& spec) {
  Chain chain(Eigen::Vector3d(0.0, 0.0, sim::DegToRad(spec.drift_deg)));
  const Information covariance = Covariance(spec.step_m, spec.step_deg);
  for (const sim::PlanarPose& step : steps) chain.Add(step, covariance);
  return chain;
}

void CheckEnds(const Edges& loops, int frames) {
  for (const auto& loop : loops) {
    if (loop.from >= 0 && loop.to >= 0 && loop.from < frames && loop.to < frames) continue;
    throw sim::Error("a loop joins frames " + std::to_string(loop.from) + " and " +
                     std::to_string(loop.to) + ", of which there are " + std::to_string(frames));
  }
}

/// Those that odometry does not rule out.
std::vector<int> Possible(const Chain& chain, const Edges& loops, const BackEndSpec& spec) {
  std::vector<int> possible;
  const bool is_checked = spec.odometry_confidence > 0.0;
  const double limit = is_checked ? agent::ChiSquaredQuantile(spec.odometry_confidence,
                                                              agent::kFreedoms<sim::PlanarPose>)
                                  : 0.0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (is_checked && agent::OdometryError(chain, loops[i]) > limit) continue;
    possible.push_back(static_cast<int>(i));
  }
  return possible;
}

Edges EdgesAt(const Edges& loops, const std::vector<int>& places) {
  Edges edges;
  edges.reserve(places.size());
  for (const int place : places) edges.push_back(loops[static_cast<std::size_t>(place)]);
  return edges;
}

/// Whether odometry alone vouches for loops: what most of them say it says as well, by no chance.
/// Wrong runs are the rarer, the longer.
bool IsVouchedFor(const std::vector<int>& chosen, const Edges& loops, const Chain& chain,
                  const BackEndSpec& spec) {
  if (spec.lone_chance == 0.0) return false;
  std::vector<double> chances;
  chances.reserve(chosen.size());
  for (const int place : chosen) {
    chances.push_back(agent::AgreesByChance(chain, loops[static_cast<std::size_t>(place)], {}));
  }
  const auto middle = chances.begin() + static_cast<std::ptrdiff_t>(chances.size() / 2);
  std::nth_element(chances.begin(), middle, chances.end());
  constexpr std::size_t kMostCounted = 5;
  return *middle <= spec.lone_chance * static_cast<double>(std::min(kMostCounted, chances.size()));
}

/// None of them if too few support each other, and odometry does not either.
std::vector<int> Supported(std::vector<int> chosen, const Edges& loops, const Chain& chain,
                           const BackEndSpec& spec) {
  if (chosen.empty()) return chosen;
  std::vector<std::pair<int, int>> ends;
  ends.reserve(chosen.size());
  for (const int place : chosen) {
    const auto& loop = loops[static_cast<std::size_t>(place)];
    ends.emplace_back(static_cast<int>(loop.from), static_cast<int>(loop.to));
  }
  const bool is_alone = agent::SeparateLoops(ends, spec.run_gap) < spec.runs;
  if (is_alone && !IsVouchedFor(chosen, loops, chain, spec)) chosen.clear();
  return chosen;
}

std::vector<int> Chosen(const Chain& chain, const Edges& loops, const BackEndSpec& spec) {
  CheckEnds(loops, chain.size());
  std::vector<int> chosen = Possible(chain, loops, spec);
  if (spec.consistent && !chosen.empty()) {
    agent::LoopSetOptions options;
    options.confidence = spec.confidence;
    const Edges possible = EdgesAt(loops, chosen);
    std::vector<int> kept;
    for (const int member :
         agent::ConsistentLoops<sim::PlanarPose>(chain, possible, options).members) {
      kept.push_back(chosen[static_cast<std::size_t>(member)]);
    }
    chosen = std::move(kept);
  }
  return Supported(std::move(chosen), loops, chain, spec);
}

/// How many standard deviations a loop is off, at most, along, across and in yaw.
double StrainOf(const agent::PlanarPoseGraph& graph, const agent::PoseEdge<sim::PlanarPose>& loop) {
  const sim::PlanarPose& from = graph.vertices[static_cast<std::size_t>(loop.from)].pose;
  const sim::PlanarPose& to = graph.vertices[static_cast<std::size_t>(loop.to)].pose;
  const sim::PlanarPose seen = sim::Compose(sim::Inverse(from), to);
  const sim::PlanarPose off = sim::Compose(sim::Inverse(loop.measured), seen);
  const Eigen::Vector3d error(off.x, off.y, sim::WrapAngle(off.yaw));
  return (loop.information.diagonal().cwiseSqrt().array() * error.cwiseAbs().array()).maxCoeff();
}

agent::PlanarPoseGraph GraphOf(std::span<const sim::PlanarPose> odometry,
                               const std::vector<sim::PlanarPose>& steps, const BackEndSpec& spec) {
  agent::PlanarPoseGraph graph;
  graph.vertices.reserve(odometry.size());
  for (std::size_t i = 0; i < odometry.size(); ++i) {
    graph.vertices.push_back({static_cast<std::int64_t>(i), odometry[i], i == 0});
  }
  const Information information = Covariance(spec.step_m, spec.step_deg).inverse();
  graph.edges.reserve(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto from = static_cast<std::int64_t>(i);
    graph.edges.push_back({from, from + 1, steps[i], information, false});
  }
  return graph;
}

agent::PlanarPoseGraph Optimized(agent::PlanarPoseGraph graph, const Edges& loops,
                                 const BackEndSpec& spec) {
  graph.edges.insert(graph.edges.end(), loops.begin(), loops.end());
  agent::OptimizeOptions options;
  options.kernel = spec.robust;
  options.kernel_width = spec.width;
  agent::Optimize(options, &graph);
  return graph;
}

/// Optimises with the chosen loops, again and again without those that the graph strains.
void Settle(std::span<const sim::PlanarPose> odometry, const Edges& edges, const BackEndSpec& spec,
            BackEndOutcome* outcome) {
  constexpr int kMostRounds = 10;
  const std::vector<sim::PlanarPose> steps = StepsOf(odometry);
  const Chain chain = ChainOf(steps, spec);
  std::vector<int> chosen = Chosen(chain, edges, spec);
  for (int round = 0;; ++round) {
    outcome->accepted = chosen;
    outcome->graph = Optimized(GraphOf(odometry, steps, spec), EdgesAt(edges, chosen), spec);
    if (spec.most_error == 0.0 || round == kMostRounds) break;
    std::erase_if(chosen, [&](int place) {
      return StrainOf(outcome->graph, edges[static_cast<std::size_t>(place)]) > spec.most_error;
    });
    if (chosen.size() == outcome->accepted.size()) break;
    chosen = Supported(std::move(chosen), edges, chain, spec);
  }
}

}  // namespace

BackEndOutcome RunBackEnd(std::span<const sim::PlanarPose> odometry,
                          std::span<const MeasuredLoop> loops, const BackEndSpec& spec) {
  Edges edges;
  edges.reserve(loops.size());
  for (const MeasuredLoop& loop : loops) edges.push_back(EdgeOf(loop, spec));
  BackEndOutcome outcome;
  outcome.poses.assign(odometry.begin(), odometry.end());
  try {
    Settle(odometry, edges, spec, &outcome);
    for (std::size_t i = 0; i < outcome.poses.size(); ++i) {
      outcome.poses[i] = outcome.graph.vertices[i].pose;
    }
  } catch (const sim::Error& e) {
    outcome.accepted.clear();
    outcome.trouble = e.what();
  }
  return outcome;
}

}  // namespace bulletnav::bench
