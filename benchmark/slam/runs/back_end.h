// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "agent/slam/pose_graph/pose_graph.h"
#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// The later frame's body seen from the earlier one's.
struct MeasuredLoop {
  int later = 0;
  int earlier = 0;
  sim::PlanarPose motion;
};

struct BackEndOutcome {
  std::vector<int> accepted;           // positions of loops, rising
  agent::PlanarPoseGraph graph;        // a vertex a frame, as optimised
  std::vector<sim::PlanarPose> poses;  // by frame, from the first one's body
  std::string trouble;                 // empty if all went well; else poses are odometry's
};

/// Puts odometry (added up, from the first frame's body) and loops into a pose graph, leaves out
/// loops that contradict more of the others than they agree with, and optimises it.
/// Throws nothing that a user can mend: trouble of the optimiser is told in the outcome.
BackEndOutcome RunBackEnd(std::span<const sim::PlanarPose> odometry,
                          std::span<const MeasuredLoop> loops, const BackEndSpec& spec);

}  // namespace bulletnav::bench
