// SPDX-License-Identifier: MIT
#include "sim/import/up_axis.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bulletnav::sim {
namespace {

constexpr float kLayer = 0.1f;        // metres
constexpr float kFlatCosine = 0.95f;  // within 18 degrees of level
constexpr double kClearlyBetter = 1.3;

/// Root of the summed squares of the level area in each layer: large for two wide floors, small for
/// the same area spread over many shelves and treads.
double LayeredArea(const SceneMesh& mesh, int axis) {
  std::map<int, double> area_of_layer;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.positions[t[0]];
    const Eigen::Vector3f normal = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
    const float double_area = normal.norm();
    if (!(std::abs(normal[axis]) >= kFlatCosine * double_area) || double_area == 0.0f) continue;
    const float layer = std::floor(a[axis] / kLayer);
    if (!(std::abs(layer) < 1e8f)) continue;
    area_of_layer[static_cast<int>(layer)] += 0.5 * double_area;
  }
  double sum = 0.0;
  for (const auto& [layer, area] : area_of_layer) sum += area * area;
  return std::sqrt(sum);
}

/// Buildings are lower than they are wide, which tells floors from walls where both are flat.
double Score(const SceneMesh& mesh, int axis) {
  const float extent = mesh.Bounds().sizes()[axis];
  return std::isfinite(extent) ? LayeredArea(mesh, axis) / std::max(extent, kLayer) : 0.0;
}

}  // namespace

UpAxis DetectUpAxis(const SceneMesh& mesh, UpAxis usual) {
  const double y = Score(mesh, 1);
  const double z = Score(mesh, 2);
  if (usual == UpAxis::kY) return z > kClearlyBetter * y ? UpAxis::kZ : UpAxis::kY;
  return y > kClearlyBetter * z ? UpAxis::kY : UpAxis::kZ;
}

void TurnZUpToYUp(SceneMesh* mesh) {
  for (Eigen::Vector3f& p : mesh->positions) p = TurnedZUpToYUp(p);
}

}  // namespace bulletnav::sim
