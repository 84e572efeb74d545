// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/math/pose.h"

namespace bulletnav::bench {

/// How far the body has come, as odometry has it, and which frames are far back.
class Travel {
 public:
  explicit Travel(double apart_m) : apart_m_(apart_m) {}

  /// Takes the next frame's odometry; how many of the first frames are `apart_m` back.
  int Next(const sim::PlanarPose& odometry) {
    if (!travelled_.empty()) {
      metres_ += std::hypot(odometry.x - last_.x, odometry.y - last_.y);
    }
    travelled_.push_back(metres_);
    last_ = odometry;
    const auto end = std::upper_bound(travelled_.begin(), travelled_.end(), metres_ - apart_m_);
    return static_cast<int>(end - travelled_.begin());
  }
  double metres() const { return metres_; }

 private:
  double apart_m_;
  double metres_ = 0.0;
  std::vector<double> travelled_;  // rises
  sim::PlanarPose last_;
};

}  // namespace bulletnav::bench
