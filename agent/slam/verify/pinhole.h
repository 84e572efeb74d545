// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::agent {

/// A pinhole camera without distortion, in pixels; the centre of the first pixel is 0, 0.
struct Pinhole {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
};

}  // namespace bulletnav::agent
