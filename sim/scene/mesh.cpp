// SPDX-License-Identifier: MIT
#include "sim/scene/mesh.h"

#include "sim/base/check.h"

namespace bulletnav::sim {

Eigen::AlignedBox3f SceneMesh::Bounds() const {
  Eigen::AlignedBox3f box;
  for (const auto& triangle : triangles) {
    for (const std::uint32_t v : triangle) box.extend(positions[v]);
  }
  return box;
}

void SceneMesh::Validate() const {
  CHECK_EQ(uvs.size(), positions.size());
  CHECK_EQ(colors.size(), positions.size());
  CHECK_EQ(triangle_materials.size(), triangles.size());
  for (const auto& triangle : triangles) {
    for (const std::uint32_t v : triangle) CHECK_LT(v, positions.size());
  }
  for (const std::uint32_t m : triangle_materials) CHECK_LT(m, materials.size());
  for (const Material& m : materials) CHECK_LT(m.texture, static_cast<int>(textures.size()));
}

}  // namespace bulletnav::sim
