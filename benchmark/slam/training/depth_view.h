// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "benchmark/slam/training/place_config.h"
#include "benchmark/slam/truth/covisibility.h"
#include "sim/math/pose.h"
#include "sim/render/renderer.h"

namespace bulletnav::bench {

/// The camera of a body.
sim::CameraPose EyeAt(const sim::BodyPose& pose, const sim::BodySpec& body);

/// Sees depth alone, coarsely, to tell what views share. One per thread.
class DepthEye {
 public:
  /// With a quarter of the rows and columns of the data's camera. The scene must outlive it.
  DepthEye(const sim::RenderScene& scene, const PlaceDataConfig& data);

  DepthThumbnail See(const sim::BodyPose& pose);

 private:
  sim::PinholeSpec camera_;
  sim::BodySpec body_;
  std::unique_ptr<sim::Renderer> renderer_;
};

}  // namespace bulletnav::bench
