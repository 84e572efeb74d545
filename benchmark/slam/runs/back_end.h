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

/// Puts odometry (added up, from the first frame's body) and loops into a pose graph and optimises
/// it. Left out are loops that odometry rules out, then those outside of the largest set that
/// agrees two by two, then all if they come from fewer places than the spec wants, since loops
/// of one place have nothing that could contradict them, unless odometry says the same by no
/// chance; and at last those that the optimised graph strains most. See BackEndSpec. Sources:
/// Mangelson et al., ICRA 2018 (sets); the check of strain is RTAB-Map's OptimizeMaxError; the
/// places are ours. Throws nothing that a user can mend: trouble of the optimiser is told in the
/// outcome.
BackEndOutcome RunBackEnd(std::span<const sim::PlanarPose> odometry,
                          std::span<const MeasuredLoop> loops, const BackEndSpec& spec);

}  // namespace bulletnav::bench
