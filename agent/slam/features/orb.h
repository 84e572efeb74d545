// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "agent/slam/retrieval/binary_descriptor.h"

namespace bulletnav::agent {

/// A corner of a picture: column and row in pixels, the centre of the first pixel at 0, 0.
struct Corner {
  float x = 0.0f;
  float y = 0.0f;
  float size_px = 0.0f;    // diameter of what is described
  float angle_deg = 0.0f;  // its direction, clockwise from x
};

/// Corners of a picture and what is around them, one for one.
struct OrbFeatures {
  std::vector<Corner> corners;
  std::vector<BinaryDescriptor> descriptors;
};

struct OrbSpec {
  int features = 1000;      // at most; up to 100,000
  double scale = 1.2;       // between levels of the pyramid, up to 10
  int levels = 8;           // up to 32
  int fast_threshold = 20;  // grey values between a corner and its circle

  template <class V>
  void Visit(V& v) {
    v("features", features);
    v("scale", scale);
    v("levels", levels);
    v("fast_threshold", fast_threshold);
  }
  void Validate() const;
};

/// ORB of an RGB picture [height, width, 3], by OpenCV in the calling thread; the same each time.
/// None in a picture without corners. Throws sim::Error if the spec is bad, if the picture has not
/// as many bytes as its size says, or is too small for so many levels.
/// Source: Rublee et al., "ORB: an efficient alternative to SIFT or SURF", ICCV 2011.
OrbFeatures FindOrb(std::span<const std::uint8_t> rgb, int width_px, int height_px,
                    const OrbSpec& spec);

/// The same of a whole panorama, whose ends meet: corners there are found, too. Panoramas are
/// small, and next to an edge there are no corners: they are looked for in a picture twice as
/// large.
OrbFeatures FindOrbAround(std::span<const std::uint8_t> rgb, int width_px, int height_px,
                          const OrbSpec& spec);

}  // namespace bulletnav::agent
