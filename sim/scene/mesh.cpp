// SPDX-License-Identifier: MIT
#include "sim/scene/mesh.h"

#include <algorithm>

#include <fmt/core.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

void RequireEqual(const char* what, std::size_t has, const char* of, std::size_t wanted) {
  if (has == wanted) return;
  throw Error(
      fmt::format("the mesh has {} {} for {} {}; give one for each", has, what, wanted, of));
}

void RequireInRange(const char* of, std::size_t which, const char* what, std::int64_t index,
                    std::size_t size) {
  if (index >= 0 && index < static_cast<std::int64_t>(size)) return;
  throw Error(fmt::format("the mesh's {} {} names {} {} of {}", of, which, what, index, size));
}

void RequirePicture(const Texture& texture, std::size_t which) {
  const Image& image = texture.image;
  if (image.width > 0 && image.height > 0 && image.channels == 4 &&
      image.pixels.size() ==
          4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
    return;
  }
  throw Error(fmt::format("the mesh's texture {} ('{}') has no RGBA pixels", which, texture.name));
}

}  // namespace

Eigen::AlignedBox3f SceneMesh::Bounds() const {
  Eigen::AlignedBox3f box;
  for (const auto& triangle : triangles) {
    for (const std::uint32_t v : triangle) box.extend(positions[v]);
  }
  return box;
}

void SceneMesh::Validate() const {
  if (triangles.empty()) throw Error("the mesh has no triangles");
  RequireEqual("uvs", uvs.size(), "vertices", positions.size());
  RequireEqual("colors", colors.size(), "vertices", positions.size());
  RequireEqual("triangle_materials", triangle_materials.size(), "triangles", triangles.size());
  if (has_objects()) {
    RequireEqual("triangle_objects", triangle_objects.size(), "triangles", triangles.size());
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (positions[v].allFinite() && uvs[v].allFinite()) continue;
    throw Error(fmt::format("the mesh's vertex {} is not finite", v));
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::uint32_t v : triangles[t]) {
      RequireInRange("triangle", t, "vertex", v, positions.size());
    }
    RequireInRange("triangle", t, "material", triangle_materials[t], materials.size());
    if (has_objects()) {
      RequireInRange("triangle", t, "object", triangle_objects[t], objects.size());
    }
  }
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (materials[m].texture == -1) continue;
    RequireInRange("material", m, "texture", materials[m].texture, textures.size());
  }
  for (std::size_t t = 0; t < textures.size(); ++t) RequirePicture(textures[t], t);
}

}  // namespace bulletnav::sim
