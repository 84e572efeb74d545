// SPDX-License-Identifier: MIT
#include "sim/render/cpu/ray_tracer.h"

#include <limits>

namespace bulletnav::sim {
namespace {

KernelRay MakeRay(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float far) {
  return {{origin.x(), origin.y(), origin.z()}, {direction.x(), direction.y(), direction.z()}, far};
}

constexpr float kFar = std::numeric_limits<float>::max();

}  // namespace

RayTracer::RayTracer(std::span<const std::array<Eigen::Vector3f, 3>> triangles)
    : bvh_(triangles), kernels_(SupportedKernels().front()) {}

KernelScene RayTracer::scene() const {
  KernelScene scene{};
  scene.nodes = bvh_.nodes.data();
  scene.leaves = bvh_.leaves.data();
  return scene;
}

RayHit RayTracer::Cast(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const {
  const KernelRay ray = MakeRay(origin, direction, kFar);
  KernelHit hit{};
  kernels_->trace(scene(), &ray, 1, false, &hit);
  return {hit.triangle < 0 ? 0.0f : hit.t, hit.triangle};
}

bool RayTracer::IsBlocked(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const {
  const KernelRay ray = MakeRay(from, to - from, 1.0f);
  KernelHit hit{};
  kernels_->trace(scene(), &ray, 1, true, &hit);
  return hit.triangle >= 0;
}

void RayTracer::CastPacket(const Eigen::Vector3f& origin,
                           const std::array<std::array<float, 16>, 3>& directions,
                           std::array<RayHit, 16>* hits) const {
  std::array<KernelRay, 16> rays{};
  for (std::size_t i = 0; i < 16; ++i) {
    rays[i] = MakeRay(origin, {directions[0][i], directions[1][i], directions[2][i]}, kFar);
  }
  std::array<KernelHit, 16> found{};
  kernels_->trace(scene(), rays.data(), 16, false, found.data());
  for (std::size_t i = 0; i < 16; ++i) {
    (*hits)[i] = {found[i].triangle < 0 ? 0.0f : found[i].t, found[i].triangle};
  }
}

}  // namespace bulletnav::sim
