// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace bulletnav::agent {

struct StereoSpec {
  int disparities = 128;  // pixels between left and right that are tried; a multiple of 16
  int block_px = 5;       // side of what is compared, odd
  double fx = 0.0;        // pixels
  double baseline_m = 0.0;

  void Validate() const;
};

/// Depth along the left camera's axis in metres [height, width], 0 where there is none, of two
/// rectified RGB pictures [height, width, 3], by OpenCV in the calling thread. Throws sim::Error if
/// the spec is bad, a picture is not wider than `disparities`, or has not as many bytes as its size
/// says.
/// Source: Hirschmueller, "Stereo processing by semiglobal matching and mutual information", PAMI
/// 2008.
std::vector<float> StereoDepth(std::span<const std::uint8_t> left,
                               std::span<const std::uint8_t> right, int width_px, int height_px,
                               const StereoSpec& spec);

}  // namespace bulletnav::agent
