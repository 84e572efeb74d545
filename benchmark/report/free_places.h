// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "benchmark/report/canvas.h"

namespace bulletnav::bench {

/// Keeps small things on a picture from covering each other.
class FreePlaces {
 public:
  /// `bounds`: what nothing chosen should leave.
  explicit FreePlaces(const Eigen::AlignedBox2d& bounds) : bounds_(bounds) {}

  void Take(const Eigen::AlignedBox2d& box) { taken_.push_back(box); }
  void Take(const Canvas::Point& middle, const Canvas::Point& size) {
    Take(Eigen::AlignedBox2d(middle - 0.5 * size, middle + 0.5 * size));
  }

  /// The first of some middles where a box of this size covers nothing that is taken, or the one
  /// where it covers least; takes it. Expects: at least one (checked).
  Canvas::Point Choose(std::span<const Canvas::Point> middles, const Canvas::Point& size);

 private:
  /// Area that is covered or out of bounds.
  double Covered(const Eigen::AlignedBox2d& box) const;

  Eigen::AlignedBox2d bounds_;
  std::vector<Eigen::AlignedBox2d> taken_;
};

}  // namespace bulletnav::bench
