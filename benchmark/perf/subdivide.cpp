// SPDX-License-Identifier: MIT
#include "benchmark/perf/subdivide.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace bulletnav::bench {
namespace {

std::uint32_t AddMiddle(std::uint32_t a, std::uint32_t b, sim::SceneMesh* mesh) {
  mesh->positions.push_back(0.5f * (mesh->positions[a] + mesh->positions[b]));
  mesh->uvs.push_back(0.5f * (mesh->uvs[a] + mesh->uvs[b]));
  sim::Rgb8 color;
  for (std::size_t c = 0; c < 3; ++c) {
    color[c] = static_cast<std::uint8_t>((mesh->colors[a][c] + mesh->colors[b][c]) / 2);
  }
  mesh->colors.push_back(color);
  return static_cast<std::uint32_t>(mesh->positions.size()) - 1;
}

}  // namespace

sim::SceneMesh Subdivided(const sim::SceneMesh& mesh, std::size_t triangles) {
  sim::SceneMesh fine = mesh;
  while (fine.triangles.size() < triangles) {
    // Every triangle into four; a shared edge gets one middle.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), 0);
      if (is_new) place->second = AddMiddle(a, b, &fine);
      return place->second;
    };
    const auto before = std::exchange(fine.triangles, {});
    const auto materials = std::exchange(fine.triangle_materials, {});
    const std::size_t n = before.size();
    const std::size_t cut = std::min(n, (triangles - n + 2) / 3);
    for (std::size_t t = 0; t < n; ++t) {
      const auto [a, b, c] = before[t];
      if ((t + 1) * cut / n == t * cut / n) {
        fine.triangles.push_back(before[t]);
        fine.triangle_materials.push_back(materials[t]);
        continue;
      }
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      for (const auto& part : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
        fine.triangles.push_back(part);
        fine.triangle_materials.push_back(materials[t]);
      }
    }
  }
  return fine;
}

}  // namespace bulletnav::bench
