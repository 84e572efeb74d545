// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/render/cpu/device.h"

namespace bulletnav::sim {

/// First hit of a ray; `triangle` is -1 where it meets nothing.
struct RayHit {
  float t = 0.0f;  // in lengths of the direction given
  std::int32_t triangle = -1;
};

/// Plain Embree: rays of any origin and direction against triangles. For baking light, as the
/// oracle of the panorama renderers, and as the bound they are measured by. Queries are
/// thread-safe.
class Raycaster {
 public:
  explicit Raycaster(std::span<const std::array<Eigen::Vector3f, 3>> triangles);

  RayHit Cast(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const;
  /// Whether anything stands between two points.
  bool IsBlocked(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;
  /// Sixteen rays at once from one origin, the fastest way Embree has: directions as x, y, z
  /// arrays.
  void CastPacket(const Eigen::Vector3f& origin,
                  const std::array<std::array<float, 16>, 3>& directions,
                  std::array<RayHit, 16>* hits) const;

 private:
  EmbreeDevice device_;
  EmbreeScene scene_;
};

}  // namespace bulletnav::sim
