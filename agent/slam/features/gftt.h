// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "agent/slam/features/orb.h"

namespace bulletnav::agent {

struct GfttSpec {
  int features = 500;      // at most
  double quality = 0.001;  // of a corner, as a share of the best one's
  double apart_px = 7.0;   // between corners

  template <class V>
  void Visit(V& v) {
    v("features", features);
    v("quality", quality);
    v("apart_px", apart_px);
  }
  void Validate() const;
};

/// Corners that can be tracked well, described as ORB describes: RTAB-Map's GFTT/ORB. Of an RGB
/// picture [height, width, 3], by OpenCV in the calling thread; the same each time. None near the
/// picture's edges, where there is not enough around them. Throws sim::Error as FindOrb does.
/// Source: Shi and Tomasi, "Good features to track", CVPR 1994.
OrbFeatures FindGftt(std::span<const std::uint8_t> rgb, int width_px, int height_px,
                     const GfttSpec& spec);

}  // namespace bulletnav::agent
