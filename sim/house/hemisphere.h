// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "sim/base/elementary.h"
#include "sim/render/cpu/ray_tracer.h"

namespace bulletnav::sim {

/// Cosine-weighted directions about +z, the same wherever they are used, so that neighbours agree.
template <std::size_t kCount>
std::array<Eigen::Vector3f, kCount> HemisphereDirections() {
  std::array<Eigen::Vector3f, kCount> directions;
  for (std::size_t i = 0; i < kCount; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / static_cast<float>(kCount);
    const float angle =
        static_cast<float>(i) * std::numbers::pi_v<float> * (3.0f - std::sqrt(5.0f));
    const float r = std::sqrt(u);
    directions[i] = {r * Cos(angle), r * Sin(angle), std::sqrt(1.0f - u)};
  }
  return directions;
}

/// A direction about +z turned to lie about `normal`.
inline Eigen::Vector3f Turned(const Eigen::Vector3f& direction, const Eigen::Vector3f& normal) {
  const Eigen::Vector3f helper =
      std::abs(normal.y()) < 0.9f ? Eigen::Vector3f(0, 1, 0) : Eigen::Vector3f(1, 0, 0);
  const Eigen::Vector3f u = helper.cross(normal).normalized();
  const Eigen::Vector3f v = normal.cross(u);
  return direction.x() * u + direction.y() * v + direction.z() * normal;
}

/// Calls visit(hit, direction) for every (kCount / 16)-th of the directions about `normal`, from
/// number `first` on: sixteen of the whole hemisphere.
template <std::size_t kCount, class Visit>
void CastHemisphere(const RayTracer& scene, const std::array<Eigen::Vector3f, kCount>& directions,
                    std::size_t first, const Eigen::Vector3f& point, const Eigen::Vector3f& normal,
                    const Visit& visit) {
  std::array<std::array<float, 16>, 3> rays{};
  for (std::size_t i = 0; i < 16; ++i) {
    const Eigen::Vector3f d = Turned(directions[i * (kCount / 16) + first], normal);
    for (int axis = 0; axis < 3; ++axis) rays[static_cast<std::size_t>(axis)][i] = d[axis];
  }
  std::array<RayHit, 16> hits;
  scene.CastPacket(point, rays, &hits);
  for (std::size_t i = 0; i < 16; ++i) {
    visit(hits[i], Eigen::Vector3f(rays[0][i], rays[1][i], rays[2][i]));
  }
}

}  // namespace bulletnav::sim
