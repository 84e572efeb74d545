// SPDX-License-Identifier: MIT
#include "sim/import/up_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace bulletnav::sim {
namespace {

constexpr float kLayer = 0.1f;        // metres
constexpr float kFlatCosine = 0.95f;  // within 18 degrees of level
constexpr double kClearlyBetter = 1.3;
constexpr double kNothing = 0.15;  // of the area that faces along another axis: tops of walls
constexpr double kMuch = 0.2;

/// As long as twice the triangle's area.
Eigen::Vector3f NormalOf(const SceneMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Eigen::Vector3f& a = mesh.positions[triangle[0]];
  return (mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a);
}

/// Area that faces along each axis.
Eigen::Vector3d FacingArea(const SceneMesh& mesh) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f normal = NormalOf(mesh, t);
    const float double_area = normal.norm();
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(normal[axis]) >= kFlatCosine * double_area) area[axis] += 0.5 * double_area;
    }
  }
  return area;
}

/// Walls without floor and ceiling: hardly anything faces along `up`, along which the mesh is
/// lowest, and much along both of the others. Turned on its side such a building would have walls
/// in one direction alone.
bool IsWallsAlone(const Eigen::Vector3d& area, const Eigen::Vector3f& size, int up) {
  const double one = area[up == 1 ? 0 : 1];
  const double other = area[up == 2 ? 0 : 2];
  if (!(size[up] <= size.minCoeff())) return false;
  return area[up] < kNothing * std::max(one, other) &&
         std::min(one, other) > kMuch * std::max(one, other);
}

/// Root of the summed squares of the level area in each layer: large for two wide floors, small for
/// the same area spread over many shelves and treads.
double LayeredArea(const SceneMesh& mesh, int axis) {
  std::map<int, double> area_of_layer;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f normal = NormalOf(mesh, t);
    const float double_area = normal.norm();
    if (!(std::abs(normal[axis]) >= kFlatCosine * double_area) || double_area == 0.0f) continue;
    const float layer = std::floor(mesh.positions[t[0]][axis] / kLayer);
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
  const Eigen::Vector3d area = FacingArea(mesh);
  const Eigen::Vector3f size = mesh.Bounds().sizes();
  if (IsWallsAlone(area, size, 1)) return UpAxis::kY;
  if (IsWallsAlone(area, size, 2)) return UpAxis::kZ;
  const double y = Score(mesh, 1);
  const double z = Score(mesh, 2);
  if (usual == UpAxis::kY) return z > kClearlyBetter * y ? UpAxis::kZ : UpAxis::kY;
  return y > kClearlyBetter * z ? UpAxis::kY : UpAxis::kZ;
}

void TurnZUpToYUp(SceneMesh* mesh) {
  for (Eigen::Vector3f& p : mesh->positions) p = TurnedZUpToYUp(p);
}

}  // namespace bulletnav::sim
