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
  sim::Rgb8 color{};
  for (std::size_t c = 0; c < 3; ++c) {
    color[c] = static_cast<std::uint8_t>((mesh->colors[a][c] + mesh->colors[b][c]) / 2);
  }
  mesh->colors.push_back(color);
  return static_cast<std::uint32_t>(mesh->positions.size()) - 1;
}

/// Cuts `cut` of the mesh's triangles, evenly spread over the list, into four, and their neighbours
/// where they meet, so that edges still fit.
class Cutter {
 public:
  explicit Cutter(sim::SceneMesh* mesh) : mesh_(*mesh) {}

  void Run(std::size_t cut) {
    const auto before = std::exchange(mesh_.triangles, {});
    const auto materials = std::exchange(mesh_.triangle_materials, {});
    // Nobody measures what parts belong to.
    mesh_.objects.clear();
    mesh_.triangle_objects.clear();
    const std::size_t n = before.size();
    for (std::size_t t = 0; t < n; ++t) {
      if ((t + 1) * cut / n == t * cut / n) continue;
      for (std::size_t k = 0; k < 3; ++k) Middle(before[t][k], before[t][(k + 1) % 3]);
    }
    for (std::size_t t = 0; t < n; ++t) Cut(before[t], materials[t]);
  }

 private:
  bool IsCut(std::uint32_t a, std::uint32_t b) const {
    return middles_.contains(std::minmax(a, b));
  }

  /// Cuts a triangle at those of its edges that have a middle.
  void Cut(std::array<std::uint32_t, 3> triangle, std::uint32_t material) {
    const auto is_cut = [&](std::size_t k) {
      return IsCut(triangle[k], triangle[(k + 1) % 3]);
    };
    const int cuts = (is_cut(0) ? 1 : 0) + (is_cut(1) ? 1 : 0) + (is_cut(2) ? 1 : 0);
    if (cuts == 3) return CutInFour(triangle, material);
    // So that the first edge is cut, and the last is not.
    for (int turn = 0; turn < 3 && cuts > 0 && !(is_cut(0) && !is_cut(2)); ++turn) {
      std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    }
    const auto [a, b, c] = triangle;
    if (cuts == 0) return Add(triangle, material);
    const std::uint32_t ab = Middle(a, b);
    Add({a, ab, c}, material);
    if (cuts == 1) return Add({ab, b, c}, material);
    const std::uint32_t bc = Middle(b, c);
    Add({ab, b, bc}, material);
    Add({ab, bc, c}, material);
  }

  void CutInFour(const std::array<std::uint32_t, 3>& triangle, std::uint32_t material) {
    const auto [a, b, c] = triangle;
    const std::uint32_t ab = Middle(a, b);
    const std::uint32_t bc = Middle(b, c);
    const std::uint32_t ca = Middle(c, a);
    for (const auto& part : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      Add(part, material);
    }
  }

  void Add(const std::array<std::uint32_t, 3>& triangle, std::uint32_t material) {
    mesh_.triangles.push_back(triangle);
    mesh_.triangle_materials.push_back(material);
  }

  /// A shared edge gets one middle.
  std::uint32_t Middle(std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] = middles_.try_emplace(std::minmax(a, b), 0);
    if (is_new) place->second = AddMiddle(a, b, &mesh_);
    return place->second;
  }

  sim::SceneMesh& mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

}  // namespace

sim::SceneMesh Subdivided(const sim::SceneMesh& mesh, std::size_t triangles) {
  sim::SceneMesh fine = mesh;
  while (fine.triangles.size() < triangles) {
    const std::size_t n = fine.triangles.size();
    const std::size_t missing = triangles - n;
    Cutter(&fine).Run(missing >= 3 * n ? n : (missing + 5) / 6);
  }
  return fine;
}

}  // namespace bulletnav::bench
