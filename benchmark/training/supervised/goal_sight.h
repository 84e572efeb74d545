// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "sim/math/pose.h"
#include "sim/render/projection.h"

namespace bulletnav::bench {

/// Decides from a source's depth whether a goal's place can be seen from it.
/// Source: Neural Topological SLAM, appendix B, connection label.
class GoalSight {
 public:
  explicit GoalSight(const sim::PanoramaSpec& spec);

  /// Whether the goal lies within r = 3 m and nearer than the farthest point of the 5-degree patch
  /// (in azimuth and in elevation) that is centred on its camera. Distances are level ones, between
  /// axes; pixels without return tell nothing. `rise`: metres that the goal lies higher.
  /// Expects: depth of the spec's size (checked).
  bool IsSameNode(std::span<const float> depth, const sim::PlanarPose& goal_in_source,
                  double rise = 0.0) const;

  /// Largest level range in the patch around a bearing, radians counter-clockwise from straight
  /// ahead, and an elevation, given as rise over run; 0 if nothing is seen there.
  double FarthestRange(std::span<const float> depth, double bearing, double elevation) const;

 private:
  struct Patch {
    double bearing = 0.0;
    double low = 0.0;  // rise over run
    double middle = 0.0;
    double high = 0.0;
  };
  /// The row whose middle is nearest to a patch's.
  std::size_t MiddleRow(std::size_t col, const Patch& patch) const;
  double FarthestInColumn(std::span<const float> depth, std::size_t col, const Patch& patch) const;

  sim::RayGrid rays_;
  std::vector<double> bearing_;  // [cols]
  std::vector<double> flat_;     // [cols] length of the level part of a column's rays
  double half_width_;            // radians
};

}  // namespace bulletnav::bench
