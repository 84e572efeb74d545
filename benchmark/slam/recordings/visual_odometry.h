// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "agent/slam/features/orb.h"
#include "agent/slam/verify/verify_loop.h"
#include "benchmark/slam/io/recorded_frame.h"

namespace bulletnav::bench {

/// Odometry of recordings that have none, from pictures with depth: corners of the last frame found
/// again in the next. Where too few are, or the way there and the way back are not the same, the
/// camera goes on as before. Poses are X_FC of the
/// camera, see TimedPose; the first one looks along x.
class VisualOdometry {
 public:
  explicit VisualOdometry(const Intrinsics& camera);

  agent::SpatialPose Next(const sim::Image& color, const DepthPicture& depth);
  int steps() const { return steps_; }
  /// Steps that were not seen.
  int guessed() const { return guessed_; }

 private:
  struct Frame {
    agent::OrbFeatures features;
    std::vector<float> depths;

    agent::DepthCorners corners() const { return {&features, depths}; }
  };
  std::optional<agent::SpatialPose> Motion(const Frame& from, const Frame& to) const;

  Intrinsics camera_;
  std::optional<Frame> last_;
  agent::SpatialPose pose_;
  agent::SpatialPose step_;
  int steps_ = 0;
  int guessed_ = 0;
};

}  // namespace bulletnav::bench
