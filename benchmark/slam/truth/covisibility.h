// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "benchmark/slam/io/tum.h"
#include "benchmark/slam/truth/camera_lens.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {

/// How a camera stands that is not level, or not as high as others: from its own axes ahead, left,
/// up to level ones, which look the same way in the plane; and metres over the world's ground.
struct CameraTilt {
  Eigen::Matrix3d level_from_camera = Eigen::Matrix3d::Identity();
  double height = 0.0;
};

/// What of a frame is kept to tell whether two frames see the same things: a coarse depth picture
/// and points of it.
struct DepthThumbnail {
  DepthPicture depth;                   // of every `kCoarse`-th pixel
  CameraLens lens;                      // of the coarse picture
  std::vector<Eigen::Vector3f> points;  // seen from the camera: metres ahead, to the left, up
  std::vector<Eigen::Vector3f> facing;  // of each point: where its surface faces, or zero
  std::optional<CameraTilt> tilt = {};  // none: level, at height 0
};

/// Expects: a picture of at least one pixel, with as many values as its size says (checked).
DepthThumbnail Coarsened(const DepthPicture& depth, const CameraLens& lens);

/// Of a depth picture that is as coarse already.
DepthThumbnail ThumbnailOf(DepthPicture coarse, const CameraLens& lens);

/// The share of points of `a` that fall into the picture of `b` where nothing hides them: depth
/// there differs from theirs by at most 5% and 5 cm, and `b` is not behind the surface that they
/// are on, as on the other side of a thin wall. 0 if `a` has no points. X_AB: body b seen from
/// body a; both cameras are above their body's axis, level or as their tilts say.
double ShareSeen(const DepthThumbnail& a, const DepthThumbnail& b, const sim::PlanarPose& X_AB);

/// The smaller of the shares of one frame's points that the other sees.
double Covisibility(const DepthThumbnail& a, const DepthThumbnail& b, const sim::PlanarPose& X_AB);

}  // namespace bulletnav::bench
