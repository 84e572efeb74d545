// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "sim/render/cpu/bvh.h"
#include "sim/render/kernels/kernels.h"

namespace bulletnav::sim {

/// First hit of a ray; `triangle` is -1 where it meets nothing.
struct RayHit {
  float t = 0.0f;  // in lengths of the direction given
  std::int32_t triangle = -1;
};

/// Rays of any origin and direction against triangles, with the same bits on every processor,
/// which Embree's own queries do not give: the light of generated houses hangs on it. Both sides
/// of a triangle are met. Queries are thread-safe.
class RayTracer {
 public:
  explicit RayTracer(std::span<const std::array<Eigen::Vector3f, 3>> triangles);

  RayHit Cast(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const;
  /// Whether anything stands between two points.
  bool IsBlocked(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;
  /// Sixteen rays from one origin: directions as x, y, z arrays.
  void CastPacket(const Eigen::Vector3f& origin,
                  const std::array<std::array<float, 16>, 3>& directions,
                  std::array<RayHit, 16>* hits) const;

  /// With other kernels than the fastest; the answers are the same.
  void Use(const Kernels& kernels) { kernels_ = &kernels; }

 private:
  KernelScene scene() const;

  Bvh bvh_;
  const Kernels* kernels_;
};

}  // namespace bulletnav::sim
