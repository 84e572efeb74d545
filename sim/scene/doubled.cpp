// SPDX-License-Identifier: MIT
#include "sim/scene/doubled.h"

#include <cmath>
#include <numbers>
#include <unordered_map>

#include "sim/base/elementary.h"
#include "sim/math/rng.h"
#include "sim/scene/mesh_measures.h"
#include "sim/scene/patches.h"
#include "sim/scene/refine.h"
#include "sim/scene/smooth_noise.h"

namespace bulletnav::sim {
namespace {

constexpr double kPatchSize = 2.5;  // metres
constexpr double kLongest = 1.0;    // metres

}  // namespace

void DoubleSurfaces(const Doubled& doubled, std::uint64_t seed, SceneMesh* mesh) {
  if (doubled.share <= 0.0) return;
  RefineTo(kLongest, mesh);
  const SmoothNoise noise(seed, kPatchSize);
  const float floor = FloorHeight(*mesh);
  std::vector<float> values;
  std::vector<double> areas;
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    const bool is_floor = IsOnTheFloor(*mesh, t, floor);
    values.push_back(is_floor ? -HUGE_VALF : noise.RoughAt(CentreOf(*mesh, t)));
    areas.push_back(is_floor ? 0.0 : AreaOf(*mesh, t));
  }
  const float threshold = ThresholdOf(values, areas, doubled.share);
  const double turn = Rng(seed, "doubled").Uniform(0.0, 2.0 * std::numbers::pi);
  const Eigen::Vector3f offset(static_cast<float>(doubled.offset * Cos(turn)), 0.0f,
                               static_cast<float>(doubled.offset * Sin(turn)));
  std::unordered_map<std::uint32_t, std::uint32_t> copies;
  const auto copy_of = [&](std::uint32_t corner) {
    const auto [found, is_new] = copies.try_emplace(corner, 0);
    if (!is_new) return found->second;
    found->second = CopyVertex(corner, mesh);
    mesh->positions[found->second] += offset;
    return found->second;
  };
  for (std::size_t t = 0; t < values.size(); ++t) {
    if (values[t] <= threshold) continue;
    auto corners = mesh->triangles[t];
    for (std::uint32_t& corner : corners) corner = copy_of(corner);
    AddTriangleLike(t, corners, mesh);
  }
}

}  // namespace bulletnav::sim
