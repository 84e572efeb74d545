// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>

#include "agent/slam/pose_graph/pose_graph.h"
#include "sim/math/rng.h"

namespace bulletnav::agent::tests {

/// A difference of poses as numbers, as PoseEdge says, and the pose that differs so from the
/// origin.
inline Eigen::Vector3d Numbers(const sim::PlanarPose& pose) {
  return {pose.x, pose.y, sim::WrapAngle(pose.yaw)};
}
inline Eigen::Matrix<double, 6, 1> Numbers(const SpatialPose& pose) {
  Eigen::Matrix<double, 6, 1> numbers;
  numbers << pose.position, RotationVector(pose.rotation);
  return numbers;
}
inline void FromNumbers(const Eigen::Vector3d& n, sim::PlanarPose* pose) {
  *pose = {n[0], n[1], n[2]};
}
inline void FromNumbers(const Eigen::Matrix<double, 6, 1>& n, SpatialPose* pose) {
  *pose = {n.head<3>(), RotationBy(n.tail<3>())};
}

template <class Pose>
using PoseVector = Eigen::Matrix<double, kFreedoms<Pose>, 1>;

template <class Pose>
PoseVector<Pose> RandomNumbers(double size, sim::Rng* rng) {
  PoseVector<Pose> numbers;
  for (double& number : numbers) number = size * rng->Normal();
  return numbers;
}

/// Positive definite, with correlations: eigenvalues from about 1/size^2 up.
template <class Pose>
PoseMatrix<Pose> RandomInformation(double size, sim::Rng* rng) {
  PoseMatrix<Pose> root;
  for (double& number : root.reshaped()) number = rng->Normal();
  const PoseMatrix<Pose> covariance =
      size * size * (root * root.transpose() / kFreedoms<Pose> + PoseMatrix<Pose>::Identity());
  return covariance.inverse();
}

template <class Pose>
Pose Moved(const Pose& pose, const PoseVector<Pose>& by) {
  Pose step;
  FromNumbers(by, &step);
  return Compose(pose, step);
}

/// A walk of `size` poses and `loops` loops between any two, measured with noise; vertices stand
/// where odometry says. Numbers of vertices are 10, 13, 16, ...
template <class Pose>
PoseGraph<Pose> RandomGraph(std::uint64_t seed, int size, int loops, double noise) {
  sim::Rng rng(seed, "pose graph");
  std::vector<Pose> truth(1);
  for (int i = 1; i < size; ++i)
    truth.push_back(Moved(truth.back(), RandomNumbers<Pose>(0.5, &rng)));
  PoseGraph<Pose> graph;
  graph.vertices.push_back({10, truth[0]});
  const auto join = [&](int from, int to, bool is_loop) {
    const Pose seen = Compose(Inverse(truth[static_cast<std::size_t>(from)]),
                              truth[static_cast<std::size_t>(to)]);
    graph.edges.push_back({10 + 3 * from, 10 + 3 * to,
                           Moved(seen, RandomNumbers<Pose>(noise, &rng)),
                           RandomInformation<Pose>(noise, &rng), is_loop});
  };
  for (int i = 1; i < size; ++i) {
    join(i - 1, i, false);
    graph.vertices.push_back(
        {10 + 3 * i, Compose(graph.vertices.back().pose, graph.edges.back().measured)});
  }
  for (int i = 0; i < loops; ++i) {
    const int from = rng.Below(size);
    join(from, (from + 1 + rng.Below(size - 1)) % size, true);
  }
  return graph;
}

}  // namespace bulletnav::agent::tests
