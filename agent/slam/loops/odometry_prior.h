// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include <Eigen/Core>

#include "sim/math/pose.h"

namespace bulletnav::agent {

/// How much a pair's score loses where odometry has its frames far apart.
struct OdometryPriorSpec {
  double odometry_weight = 0.0;   // of the squared distance, see OdometryTrack::Against; 0: none
  double odometry_reach_m = 5.0;  // frames as near to each other often see the same things

  template <class V>
  void Visit(V& v) {
    v("odometry_weight", odometry_weight);
    v("odometry_reach_m", odometry_reach_m);
  }
  /// Throws sim::Error.
  void Validate() const;
};

/// Where odometry has the frames of a drive, and how unsure it is of any as seen from any other: .3
/// degrees and 1 cm a step, and a tenth of a degree a step that all steps share, as the back end
/// takes it by default.
class OdometryTrack {
 public:
  /// The next frame, from the first frame's body.
  void Add(const sim::PlanarPose& pose);

  /// Metres between two frames. Expects: frames that were added.
  double Apart(int later, int earlier) const;
  /// Square metres: the variance of the later frame's place as seen from the earlier one, along
  /// both axes together. Cost: constant. Expects: earlier <= later.
  double Variance(int later, int earlier) const;

  /// What odometry says against a pair of frames, 0 to 2: the weight times the squared distance
  /// beyond reach, in standard deviations of odometry and of a metre, since what is seen from two
  /// places ends nowhere sharply. Ours: pictures alone take rooms that look alike for one.
  double Against(int later, int earlier, const OdometryPriorSpec& spec) const;

 private:
  std::vector<Eigen::Vector2d> places_;
  std::vector<Eigen::Vector2d> sums_;  // of the places up to a frame
  std::vector<double> squares_;        // of their squared lengths
};

}  // namespace bulletnav::agent
