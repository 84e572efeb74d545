// SPDX-License-Identifier: MIT
#include "agent/slam/verify/projected_matches.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

/// Corners in squares of a side of `pixels`, so that those near a place are found.
class CornerGrid {
 public:
  CornerGrid(const OrbFeatures& features, double pixels) : features_(features), pixels_(pixels) {
    for (std::size_t i = 0; i < features.corners.size(); ++i) {
      cells_[CellOf(features.corners[i].x, features.corners[i].y)].push_back(i);
    }
  }

  /// Takes the corner near a place that is most like a descriptor, if one is; each only once.
  bool Take(const Eigen::Vector2d& at, const BinaryDescriptor& descriptor, int match_bits) {
    std::optional<std::size_t> best;
    int best_bits = match_bits + 1;
    for (const std::size_t i : Around(at)) {
      if (!IsNear(i, at)) continue;
      const int bits = Distance(features_.descriptors[i], descriptor);
      if (bits >= best_bits) continue;
      best = i;
      best_bits = bits;
    }
    return best && taken_.emplace(*best, true).second;
  }

 private:
  std::pair<int, int> CellOf(double x, double y) const {
    return {static_cast<int>(std::floor(x / pixels_)), static_cast<int>(std::floor(y / pixels_))};
  }
  /// Corners in the square of a place and in those around it.
  std::vector<std::size_t> Around(const Eigen::Vector2d& at) const {
    std::vector<std::size_t> corners;
    const auto [col, row] = CellOf(at.x(), at.y());
    for (int square = 0; square < 9; ++square) {
      const auto cell = cells_.find({col + square % 3 - 1, row + square / 3 - 1});
      if (cell != cells_.end()) {
        corners.insert(corners.end(), cell->second.begin(), cell->second.end());
      }
    }
    return corners;
  }
  bool IsNear(std::size_t i, const Eigen::Vector2d& at) const {
    const Corner& corner = features_.corners[i];
    return std::hypot(corner.x - at.x(), corner.y - at.y()) <= pixels_;
  }

  const OrbFeatures& features_;
  double pixels_;
  std::map<std::pair<int, int>, std::vector<std::size_t>> cells_;
  std::map<std::size_t, bool> taken_;
};

/// A corner as a point before the camera of frame `a`.
Eigen::Vector3d PointOf(const Corner& corner, double depth, const Pinhole& camera,
                        const sim::PlanarPose& X_AG) {
  const double right = (corner.x - camera.cx) / camera.fx * depth;
  const double down = (corner.y - camera.cy) / camera.fy * depth;
  const sim::PlanarPose in_a = sim::Compose(X_AG, {depth, -right, 0.0});
  return {-in_a.y, down, in_a.x};
}

}  // namespace

int CountProjected(std::span<const GroupFrame> group, const OrbFeatures& b, const SpatialPose& X_AB,
                   const Pinhole& camera, const ProjectionSpec& spec) {
  BULLETNAV_CHECK(spec.pixels > 0.0);
  const SpatialPose from_a = Inverse(X_AB);
  CornerGrid grid(b, spec.pixels);
  int count = 0;
  for (const GroupFrame& frame : group) {
    const OrbFeatures& features = *frame.seen.features;
    BULLETNAV_CHECK(frame.seen.depths_m.size() == features.corners.size());
    for (std::size_t i = 0; i < features.corners.size(); ++i) {
      const double depth = frame.seen.depths_m[i];
      if (!(depth > 0.0)) continue;
      const Eigen::Vector3d in_a = PointOf(features.corners[i], depth, camera, frame.X_AG);
      const Eigen::Vector3d in_b = from_a.rotation * in_a + from_a.position;
      if (!(in_b.z() > 0.0)) continue;
      const Eigen::Vector2d at(camera.fx * in_b.x() / in_b.z() + camera.cx,
                               camera.fy * in_b.y() / in_b.z() + camera.cy);
      if (grid.Take(at, features.descriptors[i], spec.match_bits)) ++count;
    }
  }
  return count;
}

}  // namespace bulletnav::agent
