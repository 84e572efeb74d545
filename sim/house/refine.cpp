// SPDX-License-Identifier: MIT
#include "sim/house/refine.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

namespace bulletnav::sim {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::uint64_t EdgeKey(std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  return std::uint64_t{low} << 32 | high;
}

std::uint32_t AddMiddle(std::uint32_t a, std::uint32_t b, SceneMesh* mesh) {
  mesh->positions.push_back(0.5f * (mesh->positions[a] + mesh->positions[b]));
  mesh->uvs.push_back(0.5f * (mesh->uvs[a] + mesh->uvs[b]));
  Rgb8 color{};
  for (std::size_t c = 0; c < color.size(); ++c) {
    color[c] = static_cast<std::uint8_t>((mesh->colors[a][c] + mesh->colors[b][c]) / 2);
  }
  mesh->colors.push_back(color);
  return static_cast<std::uint32_t>(mesh->positions.size()) - 1;
}

constexpr std::uint32_t kNone = ~0u;

/// Calls add(part) for the parts of a triangle whose edges ab, bc, ca have the middles `m` (kNone
/// where not halved).
template <class Add>
void ForParts(const Triangle& t, const Triangle& m, const Add& add) {
  const auto halved = std::count_if(m.begin(), m.end(), [](auto v) {
    return v != kNone;
  });
  if (halved == 0) return add(t);
  if (halved == 3) {
    add({t[0], m[0], m[2]});
    add({m[0], t[1], m[1]});
    add({m[2], m[1], t[2]});
    return add({m[0], m[1], m[2]});
  }
  // Turned so that the first edge is halved, and with two, the last is not.
  std::size_t k = 0;
  while (m[k] == kNone || (halved == 2 && m[(k + 2) % 3] != kNone)) ++k;
  const std::uint32_t a = t[k];
  const std::uint32_t b = t[(k + 1) % 3];
  const std::uint32_t c = t[(k + 2) % 3];
  const std::uint32_t ab = m[k];
  const std::uint32_t bc = m[(k + 1) % 3];
  add({a, ab, c});
  if (halved == 1) return add({ab, b, c});
  add({ab, bc, c});
  add({ab, b, bc});
}

}  // namespace

void RefineEdges(SceneMesh* mesh, std::vector<int>* tag, int rounds,
                 const std::function<bool(std::uint32_t, std::uint32_t)>& should_split) {
  for (int round = 0; round < rounds; ++round) {
    std::unordered_map<std::uint64_t, std::uint32_t> middles;
    middles.reserve(2 * mesh->triangles.size());
    const auto middle_of = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] = middles.try_emplace(EdgeKey(a, b), kNone);
      if (is_new && should_split(a, b)) place->second = AddMiddle(a, b, mesh);
      return place->second;
    };
    const auto add = [mesh](const Triangle& part) {
      mesh->triangles.push_back(part);
    };
    bool changed = false;
    const std::vector<Triangle> before = std::exchange(mesh->triangles, {});
    const std::vector<std::uint32_t> materials = std::exchange(mesh->triangle_materials, {});
    const std::vector<std::uint32_t> objects = std::exchange(mesh->triangle_objects, {});
    const std::vector<int> tags = std::exchange(*tag, {});
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Triangle m = {middle_of(before[i][0], before[i][1]),
                          middle_of(before[i][1], before[i][2]),
                          middle_of(before[i][2], before[i][0])};
      const std::size_t first = mesh->triangles.size();
      ForParts(before[i], m, add);
      const std::size_t count = mesh->triangles.size();
      changed = changed || count > first + 1;
      mesh->triangle_materials.resize(count, materials[i]);
      if (!objects.empty()) mesh->triangle_objects.resize(count, objects[i]);
      tag->resize(count, tags[i]);
    }
    if (!changed) return;
  }
}

}  // namespace bulletnav::sim
