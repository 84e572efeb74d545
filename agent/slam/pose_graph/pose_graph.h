// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "agent/slam/pose_graph/spatial_pose.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// How many numbers say how far two poses are apart.
template <class Pose>
inline constexpr int kFreedoms = 0;
template <>
inline constexpr int kFreedoms<sim::PlanarPose> = 3;  // x, y, yaw
template <>
inline constexpr int kFreedoms<SpatialPose> = 6;  // x, y, z, rotation vector

/// Square matrix over the differences of two poses: an information or a covariance.
template <class Pose>
using PoseMatrix = Eigen::Matrix<double, kFreedoms<Pose>, kFreedoms<Pose>>;

/// Where the body was once, as far as known.
template <class Pose>
struct PoseVertex {
  std::int64_t id = 0;
  Pose pose;  // in the graph's frame
  bool is_fixed = false;
};

/// A measurement of vertex `to` seen from vertex `from`.
/// The error is the true pose of `to` seen from the measured one, as numbers (x, y, yaw) or
/// (x, y, z, rotation vector); `information` is the inverse of its covariance, in SI units.
/// Source: Grisetti et al., "A tutorial on graph-based SLAM", 2010, section III; the frame of the
/// error is that of g2o.
template <class Pose>
struct PoseEdge {
  std::int64_t from = 0;
  std::int64_t to = 0;
  Pose measured;
  PoseMatrix<Pose> information = PoseMatrix<Pose>::Identity();
  bool is_loop = false;  // may be wrong altogether, as odometry is not
};

/// Poses and what is known of their differences; Pose is sim::PlanarPose or SpatialPose.
template <class Pose>
struct PoseGraph {
  std::vector<PoseVertex<Pose>> vertices;
  std::vector<PoseEdge<Pose>> edges;
};

using PlanarPoseGraph = PoseGraph<sim::PlanarPose>;
using SpatialPoseGraph = PoseGraph<SpatialPose>;

/// How a graph hangs together.
struct PoseGraphLinks {
  std::vector<std::pair<int, int>> ends;  // by edge: positions of its vertices
  std::vector<int> piece;                 // by vertex: pieces count from 0, by their first vertex
  int pieces = 0;
};

}  // namespace bulletnav::agent
