// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <utility>

#include "agent/slam/pose_graph/pose_graph.h"
#include "sim/config/enum_names.h"

namespace bulletnav::agent {

/// How much less a loop's error counts the larger it is, so that wrong loops bend little.
enum class RobustKernel { kNone, kHuber, kCauchy };

}  // namespace bulletnav::agent

template <>
struct bulletnav::sim::EnumNames<bulletnav::agent::RobustKernel> {
  static constexpr std::array kNames = {
      std::pair{"none", bulletnav::agent::RobustKernel::kNone},
      std::pair{"huber", bulletnav::agent::RobustKernel::kHuber},
      std::pair{"cauchy", bulletnav::agent::RobustKernel::kCauchy}};
};

namespace bulletnav::agent {

struct OptimizeOptions {
  RobustKernel kernel = RobustKernel::kNone;  // of loop edges; odometry is never doubted
  double kernel_width = 3.0;                  // standard deviations, from which on it works
  int max_iterations = 100;
  bool allow_pieces = false;  // else a graph in pieces is an error
};

/// Costs are half the sum of e^T * information * e, through the kernel where there is one.
struct OptimizeSummary {
  double initial_cost = 0.0;
  double final_cost = 0.0;
  int iterations = 0;
  bool converged = false;  // not stopped by max_iterations
  int pieces = 1;
};

/// Moves the vertices of a graph to where the cost is least, by Levenberg and Marquardt's method
/// from where they are. What is fixed stays, and in each piece without a fixed vertex the first
/// one.
/// One thread, the same bytes each time; from 2,000 vertices on, on one kind of processor. Cost:
/// mostly that of a sparse Cholesky factorisation an iteration. Throws sim::Error as LinksOf and
/// CheckOnePiece do, for options that are not positive, and if no step can be computed. Source:
/// Grisetti et al., "A tutorial on graph-based SLAM", 2010. Errors are weighted with the transpose
/// of L, information = L * L^T, so that correlations count.
template <class Pose>
OptimizeSummary Optimize(const OptimizeOptions& options, PoseGraph<Pose>* graph);

}  // namespace bulletnav::agent
