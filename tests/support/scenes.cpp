// SPDX-License-Identifier: MIT
#include "tests/support/scenes.h"

#include <cstdlib>

namespace bulletnav::tests {
namespace {

using Vec = Eigen::Vector3f;

std::uint32_t FlatMaterial(const sim::Rgb8& color, sim::SceneMesh* mesh) {
  for (std::size_t i = 0; i < mesh->materials.size(); ++i) {
    if (mesh->materials[i].base_color == color) return static_cast<std::uint32_t>(i);
  }
  mesh->materials.push_back({"flat", color, -1});
  return static_cast<std::uint32_t>(mesh->materials.size()) - 1;
}

}  // namespace

void AddQuad(const Vec& a, const Vec& b, const Vec& c, const Vec& d, const sim::Rgb8& color,
             sim::SceneMesh* mesh) {
  const auto base = static_cast<std::uint32_t>(mesh->positions.size());
  const std::uint32_t material = FlatMaterial(color, mesh);
  const Eigen::Vector2f corners[] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  int i = 0;
  for (const Vec& p : {a, b, c, d}) {
    mesh->positions.push_back(p);
    mesh->uvs.push_back(corners[i++]);
    mesh->colors.push_back(sim::kWhite);
  }
  mesh->triangles.push_back({base, base + 1, base + 2});
  mesh->triangles.push_back({base, base + 2, base + 3});
  mesh->triangle_materials.insert(mesh->triangle_materials.end(), 2, material);
}

void AddBox(const Vec& low, const Vec& high, const sim::Rgb8& color, sim::SceneMesh* mesh) {
  const auto at = [&](int x, int y, int z) {
    return Vec(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
  };
  AddQuad(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1), color, mesh);
  AddQuad(at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), color, mesh);
  AddQuad(at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), color, mesh);
  AddQuad(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0), color, mesh);
  AddQuad(at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0), color, mesh);
  AddQuad(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1), color, mesh);
}

sim::SceneMesh BoxRoom(float width, float height, float depth) {
  sim::SceneMesh mesh;
  const float w = width;
  const float h = height;
  const float d = -depth;
  AddQuad({0, 0, 0}, {w, 0, 0}, {w, 0, d}, {0, 0, d}, {120, 90, 60}, &mesh);    // floor
  AddQuad({0, h, d}, {w, h, d}, {w, h, 0}, {0, h, 0}, {240, 240, 240}, &mesh);  // ceiling
  AddQuad({0, 0, d}, {w, 0, d}, {w, h, d}, {0, h, d}, {200, 60, 60}, &mesh);    // ahead, -z
  AddQuad({w, 0, 0}, {0, 0, 0}, {0, h, 0}, {w, h, 0}, {60, 200, 60}, &mesh);    // behind
  AddQuad({0, 0, 0}, {0, 0, d}, {0, h, d}, {0, h, 0}, {60, 60, 200}, &mesh);    // left
  AddQuad({w, 0, d}, {w, 0, 0}, {w, h, 0}, {w, h, d}, {200, 200, 60}, &mesh);   // right
  return mesh;
}

sim::SceneMesh LCorridor(float a, float b, float width, float height) {
  sim::SceneMesh mesh;
  const sim::Rgb8 floor = {120, 120, 120};
  const sim::Rgb8 wall = {200, 180, 160};
  const float w = width;
  AddQuad({0, 0, 0}, {a, 0, 0}, {a, 0, -w}, {0, 0, -w}, floor, &mesh);
  AddQuad({a - w, 0, -w}, {a, 0, -w}, {a, 0, -b}, {a - w, 0, -b}, floor, &mesh);
  const Vec outline[] = {{0, 0, 0},      {a, 0, 0},      {a, 0, -b},
                         {a - w, 0, -b}, {a - w, 0, -w}, {0, 0, -w}};
  for (int i = 0; i < 6; ++i) {
    const Vec& p = outline[i];
    const Vec& q = outline[(i + 1) % 6];
    const Vec up(0, height, 0);
    AddQuad(q, p, p + up, q + up, wall, &mesh);
  }
  return mesh;
}

std::optional<std::filesystem::path> SharedScene(const std::string& name) {
  namespace fs = std::filesystem;
  const char* folder = std::getenv("BULLETNAV_SCENES");
  const fs::path scenes =
      folder != nullptr ? fs::path(folder) : fs::path(BULLETNAV_SOURCE_DIR) / "../shared/scenes";
  const fs::path file = scenes / name / "scene.obj";
  return fs::exists(file) ? std::optional(file) : std::nullopt;
}

}  // namespace bulletnav::tests
