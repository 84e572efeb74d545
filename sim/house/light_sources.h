// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/house/lighting.h"
#include "sim/house/mesh_builder.h"
#include "sim/render/cpu/ray_tracer.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// A patch that gives light.
struct LightPatch {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // zero: gives light all around
  Eigen::Vector3f power = Eigen::Vector3f::Zero();   // radiance times area, RGB
};

/// The light that windows and lamps throw directly.
class LightSources {
 public:
  /// Collects the glowing triangles: windows are cut into patches, a lamp's parts joined into one,
  /// of `lamp_power` (radiance times area) whatever its size.
  LightSources(const SceneMesh& mesh, std::span<const int> glow_of_triangle,
               float lamp_power = LightSpec{}.lamp_power);

  /// Irradiance at a point that faces `normal`, shadows by `scene`.
  Eigen::Vector3f Irradiance(const RayTracer& scene, const Eigen::Vector3f& point,
                             const Eigen::Vector3f& normal) const;

 private:
  void AddWindowTriangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                         const Eigen::Vector3f& c, int halvings);
  void AddLampPart(const Eigen::Vector3f& centre, float area);

  std::vector<LightPatch> patches_;
  std::size_t windows_ = 0;  // the first patches are of windows
};

}  // namespace bulletnav::sim
