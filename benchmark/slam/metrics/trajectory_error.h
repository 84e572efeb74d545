// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/math/pose.h"

namespace bulletnav::bench {

/// How an estimate is laid over the truth before distances are taken; never scaled.
enum class Alignment {
  kStart,   // first pose on first pose
  kPlanar,  // turned and moved so that the sum of squared distances is least
};

/// Absolute pose error: distances in metres between where the body was and where it is said to have
/// been. Source: Sturm et al., IROS 2012; alignment by Umeyama, 1991, without scale.
struct TrajectoryError {
  double min = 0.0;
  double mean = 0.0;
  double max = 0.0;
  double rmse = 0.0;

  template <class V>
  void Visit(V& v) {
    v("min", min);
    v("mean", mean);
    v("max", max);
    v("rmse", rmse);
  }
};

/// The pose X_TE that lays an estimate E over truth T, pose by pose. Throws sim::Error if there are
/// not as many poses of one as of the other, none, or one that is not finite.
sim::PlanarPose AlignmentOf(std::span<const sim::PlanarPose> truth,
                            std::span<const sim::PlanarPose> estimate, Alignment alignment);

/// Pose by pose, after alignment. Throws as AlignmentOf.
std::vector<double> PoseErrors(std::span<const sim::PlanarPose> truth,
                               std::span<const sim::PlanarPose> estimate, Alignment alignment);
TrajectoryError MeasureTrajectory(std::span<const sim::PlanarPose> truth,
                                  std::span<const sim::PlanarPose> estimate, Alignment alignment);

}  // namespace bulletnav::bench
