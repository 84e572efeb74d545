// SPDX-License-Identifier: MIT
#include "sim/scene/submesh.h"

#include <map>

#include "sim/base/check.h"

namespace bulletnav::sim {
namespace {

class Taker {
 public:
  explicit Taker(const SceneMesh& mesh) : mesh_(mesh) {
    if (mesh.has_objects()) taken_.objects.push_back(mesh.objects[0]);
  }

  void Take(std::size_t triangle) {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const std::uint32_t first = Vertex(a);
    const std::uint32_t second = Vertex(b);
    taken_.triangles.push_back({first, second, Vertex(c)});
    taken_.triangle_materials.push_back(MaterialOf(mesh_.triangle_materials[triangle]));
    if (mesh_.has_objects()) {
      taken_.triangle_objects.push_back(ObjectOf(mesh_.triangle_objects[triangle]));
    }
  }

  SceneMesh Taken() && { return std::move(taken_); }

 private:
  std::uint32_t Vertex(std::uint32_t old) {
    const auto next = static_cast<std::uint32_t>(taken_.positions.size());
    const auto [place, is_new] = vertices_.try_emplace(old, next);
    if (is_new) {
      taken_.positions.push_back(mesh_.positions[old]);
      taken_.uvs.push_back(mesh_.uvs[old]);
      taken_.colors.push_back(mesh_.colors[old]);
    }
    return place->second;
  }

  std::uint32_t MaterialOf(std::uint32_t old) {
    const auto next = static_cast<std::uint32_t>(taken_.materials.size());
    const auto [place, is_new] = materials_.try_emplace(old, next);
    if (is_new) {
      Material material = mesh_.materials[old];
      if (material.texture >= 0) material.texture = TextureOf(material.texture);
      taken_.materials.push_back(std::move(material));
    }
    return place->second;
  }

  int TextureOf(int old) {
    const auto next = static_cast<int>(taken_.textures.size());
    const auto [place, is_new] = textures_.try_emplace(old, next);
    if (is_new) taken_.textures.push_back(mesh_.textures[static_cast<std::size_t>(old)]);
    return place->second;
  }

  std::uint32_t ObjectOf(std::uint32_t old) {
    if (old == 0) return 0;
    const auto next = static_cast<std::uint32_t>(taken_.objects.size());
    const auto [place, is_new] = objects_.try_emplace(old, next);
    if (is_new) taken_.objects.push_back(mesh_.objects[old]);
    return place->second;
  }

  const SceneMesh& mesh_;
  SceneMesh taken_;
  std::map<std::uint32_t, std::uint32_t> vertices_;
  std::map<std::uint32_t, std::uint32_t> materials_;
  std::map<int, int> textures_;
  std::map<std::uint32_t, std::uint32_t> objects_;
};

}  // namespace

SceneMesh Submesh(const SceneMesh& mesh, const std::vector<std::size_t>& triangles) {
  BULLETNAV_CHECK(!triangles.empty());
  Taker taker(mesh);
  for (const std::size_t t : triangles) taker.Take(t);
  return std::move(taker).Taken();
}

}  // namespace bulletnav::sim
