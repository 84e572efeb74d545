// SPDX-License-Identifier: MIT
#include "sim/import/texture_limit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bulletnav::sim {
namespace {

constexpr double kTexelsAMetre = 500.0;

/// For each texture, how many of its sides fit into a metre, averaged over the area that shows it.
std::vector<double> TurnsAMetre(const SceneMesh& mesh) {
  std::vector<double> uv_area(mesh.textures.size(), 0.0);
  std::vector<double> area(mesh.textures.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int texture = mesh.materials[mesh.triangle_materials[t]].texture;
    if (texture < 0) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    const Eigen::Vector2f u = mesh.uvs[b] - mesh.uvs[a];
    const Eigen::Vector2f v = mesh.uvs[c] - mesh.uvs[a];
    const auto i = static_cast<std::size_t>(texture);
    uv_area[i] += std::abs(double{u.x()} * v.y() - double{u.y()} * v.x());
    area[i] +=
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).norm();
  }
  std::vector<double> turns;
  for (std::size_t i = 0; i < area.size(); ++i) {
    turns.push_back(area[i] > 0.0 ? std::sqrt(uv_area[i] / area[i]) : 1e9);
  }
  return turns;
}

}  // namespace

void LimitTextures(SceneMesh* mesh) {
  const std::vector<double> turns = TurnsAMetre(*mesh);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    Image& image = mesh->textures[i].image;
    int width = image.width;
    int height = image.height;
    while (std::max(width, height) * turns[i] > kTexelsAMetre && std::max(width, height) > 1) {
      width = std::max(1, width / 2);
      height = std::max(1, height / 2);
    }
    image = Resize(image, width, height);
  }
}

}  // namespace bulletnav::sim
