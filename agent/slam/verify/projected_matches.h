// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "agent/slam/verify/verify_loop.h"

namespace bulletnav::agent {

/// A frame, and how its upright body stood as seen from the body of frame `a`.
struct GroupFrame {
  DepthCorners seen;
  sim::PlanarPose X_AG;
};

struct ProjectionSpec {
  double pixels = 8.0;  // between where a point should be and a corner
  int match_bits = 75;  // in which their descriptors may differ
};

/// How many corners of `b` are points of a group of frames, which see them too, where X_AB, the
/// camera of `b` seen from that of frame `a`, says that they are; a corner counts once. Cameras of
/// the group are level and above their body's axis. Cost: points x corners near them.
/// Source: the search by projection of ORB-SLAM (Mur-Artal et al., T-RO 2015).
int CountProjected(std::span<const GroupFrame> group, const OrbFeatures& b, const SpatialPose& X_AB,
                   const Pinhole& camera, const ProjectionSpec& spec);

}  // namespace bulletnav::agent
