// SPDX-License-Identifier: MIT
#include "tests/support/seen_triangles.h"

#include <array>
#include <cstddef>

#include "sim/base/elementary.h"
#include "sim/render/cpu/ray_tracer.h"

namespace bulletnav::tests {

std::vector<std::int32_t> SeenTriangles(const sim::SceneMesh& mesh, const sim::CameraSpec& camera,
                                        const sim::CameraPose& pose) {
  std::vector<std::array<Eigen::Vector3f, 3>> corners;
  for (const auto& [a, b, c] : mesh.triangles) {
    corners.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
  }
  const sim::RayTracer tracer(corners);
  const sim::RayGrid rays(camera);
  const sim::PictureSize size = sim::SizeOf(camera);
  const auto cols = static_cast<std::size_t>(size.cols);
  const float c = sim::Cos(pose.yaw);
  const float s = sim::Sin(pose.yaw);
  std::vector<std::int32_t> seen;
  for (std::size_t i = 0; i < size.pixels(); ++i) {
    const Eigen::Vector3f d = rays.Direction(i / cols, i % cols);
    seen.push_back(
        tracer.Cast(pose.position, {d.x() * c + d.z() * s, d.y(), d.z() * c - d.x() * s}).triangle);
  }
  return seen;
}

}  // namespace bulletnav::tests
