// SPDX-License-Identifier: MIT
#include "benchmark/report/free_places.h"

#include <limits>

#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

double Shared(const Eigen::AlignedBox2d& a, const Eigen::AlignedBox2d& b) {
  const Eigen::AlignedBox2d both = a.intersection(b);
  return both.isEmpty() ? 0.0 : both.volume();
}

}  // namespace

Canvas::Point FreePlaces::Choose(std::span<const Canvas::Point> middles,
                                 const Canvas::Point& size) {
  BULLETNAV_CHECK(!middles.empty());
  Canvas::Point best = middles.front();
  double least = std::numeric_limits<double>::infinity();
  for (const Canvas::Point& middle : middles) {
    const double covered = Covered(Eigen::AlignedBox2d(middle - 0.5 * size, middle + 0.5 * size));
    if (covered >= least) continue;
    least = covered;
    best = middle;
  }
  Take(best, size);
  return best;
}

double FreePlaces::Covered(const Eigen::AlignedBox2d& box) const {
  double covered = box.volume() - Shared(box, bounds_);
  for (const Eigen::AlignedBox2d& other : taken_) covered += Shared(box, other);
  return covered;
}

}  // namespace bulletnav::bench
