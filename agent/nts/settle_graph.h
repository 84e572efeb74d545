// SPDX-License-Identifier: MIT
#pragma once
#include "agent/slam/pose_graph/pose_graph.h"

namespace bulletnav::agent {

struct SettleOptions {
  double kernel_width = 2.0;  // standard deviations from which on a loop counts less (Cauchy)
  int rounds = 5;
};

/// Moves the vertices of a graph of poses in the plane to where its edges agree best, by Gauss and
/// Newton's method, with the fixed vertex in its place, for agents: what the second paper's system
/// does with Ceres (agent/slam/pose_graph/optimize.h), without a library of which the bits depend
/// on the processor. Vertices are numbered from 0 in their order.
/// Expects: one fixed vertex, edges between vertices that there are (both checked), one piece, and
/// information that is positive definite.
/// Cost: a sparse Cholesky factorisation a round; 20 ms for 300 vertices with as many loops, 80 ms
/// for 1,000.
/// Source: Grisetti et al., "A tutorial on graph-based SLAM", 2010, algorithm 1.
void SettleGraph(const SettleOptions& options, PlanarPoseGraph* graph);

}  // namespace bulletnav::agent
