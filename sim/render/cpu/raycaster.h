// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/render/cpu/device.h"
#include "sim/render/cpu/ray_tracer.h"

namespace bulletnav::sim {

/// Plain Embree: rays of any origin and direction against triangles, as the oracle of the renderers
/// and of RayTracer, and as the bound they are measured by. Queries are thread-safe. The last bits
/// depend on the processor.
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
