// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/depth_view.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace bulletnav::bench {
namespace {

constexpr int kCoarse = 4;  // pixels a ray, along each side

sim::PinholeSpec CoarseOf(sim::PinholeSpec camera) {
  camera.rows /= kCoarse;
  camera.cols /= kCoarse;
  return camera;
}

}  // namespace

sim::CameraPose EyeAt(const sim::BodyPose& pose, const sim::BodySpec& body) {
  const Eigen::Vector3d eye = pose.position + Eigen::Vector3d(0.0, double{body.camera_height}, 0.0);
  return {eye.cast<float>(), static_cast<float>(pose.yaw)};
}

DepthEye::DepthEye(const sim::RenderScene& scene, const PlaceDataConfig& data)
    : camera_(CoarseOf(data.camera)), body_(data.body), renderer_(scene.MakeRenderer(camera_)) {}

DepthThumbnail DepthEye::See(const sim::BodyPose& pose) {
  std::vector<float> ranges(camera_.pixels());
  const sim::CameraPose eye = EyeAt(pose, body_);
  renderer_->Render({&eye, 1}, {}, ranges);
  DepthPicture depth{camera_.cols, camera_.rows, {}};
  const double f = camera_.cols / 2.0 / camera_.tan_x();
  const Intrinsics k = {f, f, (camera_.cols - 1) / 2.0, (camera_.rows - 1) / 2.0};
  for (int row = 0; row < camera_.rows; ++row) {
    for (int col = 0; col < camera_.cols; ++col) {
      const float range = ranges[depth.metres.size()];
      const double length = std::hypot((col - k.cx) / f, (row - k.cy) / f, 1.0);
      depth.metres.push_back(range < camera_.max_depth_m ? static_cast<float>(range / length)
                                                         : 0.0f);
    }
  }
  return ThumbnailOf(std::move(depth), k);
}

}  // namespace bulletnav::bench
