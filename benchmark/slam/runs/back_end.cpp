// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/back_end.h"

#include <cstddef>
#include <numeric>

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

std::vector<int> Chosen(const std::vector<sim::PlanarPose>& steps,
                        const std::vector<agent::PoseEdge<sim::PlanarPose>>& loops,
                        const BackEndSpec& spec) {
  std::vector<int> all(loops.size());
  std::iota(all.begin(), all.end(), 0);
  if (!spec.consistent || loops.empty()) return all;
  agent::OdometryChain<sim::PlanarPose> chain;
  const Information covariance = Covariance(spec.step_m, spec.step_deg);
  for (const sim::PlanarPose& step : steps) chain.Add(step, covariance);
  agent::LoopSetOptions options;
  options.confidence = spec.confidence;
  return agent::ConsistentLoops<sim::PlanarPose>(chain, loops, options).members;
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

}  // namespace

BackEndOutcome RunBackEnd(std::span<const sim::PlanarPose> odometry,
                          std::span<const MeasuredLoop> loops, const BackEndSpec& spec) {
  const std::vector<sim::PlanarPose> steps = StepsOf(odometry);
  std::vector<agent::PoseEdge<sim::PlanarPose>> edges;
  edges.reserve(loops.size());
  for (const MeasuredLoop& loop : loops) edges.push_back(EdgeOf(loop, spec));
  BackEndOutcome outcome;
  outcome.poses.assign(odometry.begin(), odometry.end());
  try {
    outcome.accepted = Chosen(steps, edges, spec);
    outcome.graph = GraphOf(odometry, steps, spec);
    for (const int loop : outcome.accepted) {
      outcome.graph.edges.push_back(edges[static_cast<std::size_t>(loop)]);
    }
    agent::OptimizeOptions options;
    options.kernel = spec.robust;
    options.kernel_width = spec.width;
    agent::Optimize(options, &outcome.graph);
    for (std::size_t i = 0; i < outcome.poses.size(); ++i) {
      outcome.poses[i] = outcome.graph.vertices[i].pose;
    }
  } catch (const sim::Error& e) {
    outcome.trouble = e.what();
  }
  return outcome;
}

}  // namespace bulletnav::bench
