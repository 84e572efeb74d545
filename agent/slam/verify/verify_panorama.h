// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "agent/slam/features/orb.h"
#include "agent/slam/verify/panorama_lens.h"
#include "agent/slam/verify/verify_loop.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// Where corners of a panorama are, seen from the body; zero where it is not known. As many as
/// corners.
struct PlacedCorners {
  const OrbFeatures* features = nullptr;
  std::span<const Eigen::Vector3d> points;
};

/// The points of corners in a picture of level distances [height, width], metres, 0 where there is
/// none. Expects: a value a pixel (checked).
std::vector<Eigen::Vector3d> PointsAt(std::span<const float> level_m, int width_px, int height_px,
                                      const PanoramaLens& lens, const OrbFeatures& features);

/// How an upright body stood in `b`, seen from where it stood in `a`.
struct PanoramaMotion {
  sim::PlanarPose X_AB;
  int matches = 0;
  int inliers = 0;
};

/// The motion of a body between two panoramas, from corners that are found again and have places in
/// both: two pairs of points give a turn and a move, by RANSAC; then all that agree together, each
/// by how exactly it is known. A pair agrees if it is off by at most `pixels` seen from there, and
/// by a twentieth of the distance and 5 cm. Nothing if too few agree, or it is further than
/// `distance_m`. The same each time and on every processor, of the same corners.
/// Source: ours; the two-point form of Arun, Huang and Blostein, "Least-squares fitting of two 3-D
/// point sets", PAMI 1987, in the plane.
std::optional<PanoramaMotion> FindMotion(const PlacedCorners& a, const PlacedCorners& b,
                                         const PanoramaLens& lens, const VerifySpec& spec);

}  // namespace bulletnav::agent
