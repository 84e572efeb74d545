// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "sim/house/materials/color.h"

namespace bulletnav::sim::materials {

/// A function of place that repeats with the picture, sampled nx by ny times and interpolated.
/// Makes smooth functions of many octaves cheap to ask for at every pixel, and several times a
/// pixel.
class Field {
 public:
  template <class F>
  Field(int nx, int ny, const F& function) : nx_(nx), ny_(ny) {
    samples_.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) {
        samples_.push_back(
            function(Point{(static_cast<float>(x) + 0.5f) / static_cast<float>(nx),
                           (static_cast<float>(y) + 0.5f) / static_cast<float>(ny)}));
      }
    }
  }

  float operator()(Point p) const {
    const float x = Fraction(p.x - 0.5f / static_cast<float>(nx_)) * static_cast<float>(nx_);
    const float y = Fraction(p.y - 0.5f / static_cast<float>(ny_)) * static_cast<float>(ny_);
    // A fraction just below 1 may round up to the side itself.
    const int x0 = std::min(static_cast<int>(x), nx_ - 1);
    const int y0 = std::min(static_cast<int>(y), ny_ - 1);
    const int x1 = x0 + 1 == nx_ ? 0 : x0 + 1;
    const float* upper = Row(y0);
    const float* lower = Row(y0 + 1 == ny_ ? 0 : y0 + 1);
    const float u = x - static_cast<float>(x0);
    return Mix(Mix(upper[x0], upper[x1], u), Mix(lower[x0], lower[x1], u),
               y - static_cast<float>(y0));
  }

 private:
  const float* Row(int y) const {
    return &samples_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_)];
  }

  int nx_;
  int ny_;
  std::vector<float> samples_;
};

}  // namespace bulletnav::sim::materials
