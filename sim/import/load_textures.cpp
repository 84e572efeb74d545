// SPDX-License-Identifier: MIT
#include "sim/import/load_textures.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bulletnav::sim {
namespace {

constexpr double kTexelsAMetre = 500.0;
constexpr Rgb8 kGrey = {160, 160, 160};

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

Image Limited(const Image& image, double turns) {
  int width = image.width;
  int height = image.height;
  while (std::max(width, height) * turns > kTexelsAMetre && std::max(width, height) > 1) {
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
  }
  return Resize(image, width, height);
}

/// Grey is easier to live with than a white hole.
void Renumber(const std::vector<int>& new_numbers, SceneMesh* mesh) {
  for (Material& material : mesh->materials) {
    if (material.texture < 0) continue;
    material.texture = new_numbers[static_cast<std::size_t>(material.texture)];
    if (material.texture < 0) material.base_color = kGrey;
  }
}

}  // namespace

void LoadTextures(const AssimpScene& source, SceneMesh* mesh, ImportReport* report) {
  const std::vector<double> turns = TurnsAMetre(*mesh);
  std::vector<Texture> loaded;
  std::vector<int> new_numbers;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const std::string& name = mesh->textures[i].name;
    try {
      loaded.push_back({name, Limited(source.LoadTexture(name), turns[i])});
      new_numbers.push_back(static_cast<int>(loaded.size()) - 1);
    } catch (const std::runtime_error& e) {
      report->textures_missing.push_back(name + ": " + e.what());
      new_numbers.push_back(-1);
    }
  }
  mesh->textures = std::move(loaded);
  report->textures_found = mesh->textures.size();
  Renumber(new_numbers, mesh);
}

}  // namespace bulletnav::sim
