// SPDX-License-Identifier: MIT
#include "benchmark/slam/recordings/visual_odometry.h"

#include <utility>

#include "benchmark/slam/io/file_frames.h"

namespace bulletnav::bench {

VisualOdometry::VisualOdometry(const Intrinsics& camera)
    : camera_(camera), pose_(CameraInFile(sim::PlanarPose{}, 0.0)) {}

agent::SpatialPose VisualOdometry::Next(const sim::Image& color, const DepthPicture& depth) {
  Frame frame;
  frame.features = agent::FindOrb(color.pixels, color.width, color.height, {});
  frame.depths = agent::DepthsAt(depth.metres, depth.width, depth.height, frame.features);
  if (last_) {
    ++steps_;
    const auto motion = agent::FindMotion({&last_->features, last_->depths},
                                          {&frame.features, frame.depths}, camera_, {});
    if (motion) {
      step_ = motion->X_AB;
    } else {
      ++guessed_;
    }
    pose_ = agent::Compose(pose_, step_);
  }
  last_ = std::move(frame);
  return pose_;
}

}  // namespace bulletnav::bench
