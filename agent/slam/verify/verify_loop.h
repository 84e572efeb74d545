// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "agent/slam/features/orb.h"
#include "agent/slam/pose_graph/spatial_pose.h"
#include "agent/slam/verify/pinhole.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// What a frame's corners are and how far away: depth along the camera's axis in metres, 0 where
/// there is none. As many depths as corners.
struct DepthCorners {
  const OrbFeatures* features = nullptr;
  std::span<const float> depths_m;
};

/// The depths of a picture [height, width] at corners. Expects: a value a pixel (checked).
std::vector<float> DepthsAt(std::span<const float> depth, int width_px, int height_px,
                            const OrbFeatures& features);

struct VerifySpec {
  double ratio = 0.8;        // of the distances to the best and the second best match, at most
  int match_bits = 64;       // in which the descriptors of a match may differ
  int inliers = 12;          // at least
  double pixels = 3.0;       // that an inlier may be off
  int iterations = 500;      // of RANSAC, at most
  double tilt_deg = 5.0;     // that the camera may seem to pitch or roll; it is level
  double rise_m = 0.3;       // that it may seem to move up or down
  double distance_m = 20.0;  // that it may seem to move at all

  template <class V>
  void Visit(V& v) {
    v("ratio", ratio);
    v("match_bits", match_bits);
    v("inliers", inliers);
    v("pixels", pixels);
    v("iterations", iterations);
    v("tilt_deg", tilt_deg);
    v("rise_m", rise_m);
    v("distance_m", distance_m);
  }
  void Validate() const;
};

/// Corner pairs (position in `a`, in `b`) each of which is the other's best match, clearly, by
/// rising first. Cost: corners of a x corners of b.
std::vector<std::pair<int, int>> MutualMatches(const OrbFeatures& a, const OrbFeatures& b,
                                               const VerifySpec& spec);

/// How the camera stood in `b`, seen from the camera in `a` (axes x right, y down, z ahead).
struct CameraMotion {
  SpatialPose X_AB;
  int matches = 0;
  int inliers = 0;
};

/// The motion of a camera between two frames, from corners of `a`, which have depth, found again in
/// `b`: P3P with RANSAC, then all inliers together. Nothing if too few agree. The same each time.
/// Source: the geometric verification of DLoopDetector (Galvez-Lopez and Tardos, T-RO 2012), with
/// depth; Ke and Roumeliotis, "An efficient algebraic solution to P3P", CVPR 2017, by OpenCV.
std::optional<CameraMotion> FindMotion(const DepthCorners& a, const DepthCorners& b,
                                       const Pinhole& camera, const VerifySpec& spec);

/// The same motion of an upright body whose camera is above its axis, level and looking ahead.
/// Nothing if the camera seems tilted, higher or further off than the spec allows.
std::optional<sim::PlanarPose> LevelMotion(const SpatialPose& X_AB, const VerifySpec& spec);

}  // namespace bulletnav::agent
