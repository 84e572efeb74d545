// SPDX-License-Identifier: MIT
#include "sim/import/clean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <unordered_set>

#include <fmt/core.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

constexpr double kMaxBadShare = 0.1;
constexpr float kMinExtent = 0.5f;
constexpr float kMaxExtent = 2000.0f;
constexpr float kMaxOffset = 10'000.0f;
constexpr float kMinStrayDistance = 100.0f;
constexpr float kStrayFactor = 10.0f;
constexpr float kMinDoubleArea = 1e-10f;

using Triangle = std::array<std::uint32_t, 3>;

/// Keeps the triangles that `keep` accepts; returns how many went.
std::size_t Filter(SceneMesh* mesh, const std::function<bool(const Triangle&)>& keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
    if (!keep(mesh->triangles[i])) continue;
    mesh->triangles[kept] = mesh->triangles[i];
    mesh->triangle_materials[kept] = mesh->triangle_materials[i];
    if (mesh->has_objects()) mesh->triangle_objects[kept] = mesh->triangle_objects[i];
    ++kept;
  }
  const std::size_t dropped = mesh->triangles.size() - kept;
  mesh->triangles.resize(kept);
  mesh->triangle_materials.resize(kept);
  if (mesh->has_objects()) mesh->triangle_objects.resize(kept);
  return dropped;
}

void Note(std::size_t count, const char* what, ImportReport* report) {
  if (count > 0) report->skipped.push_back(std::to_string(count) + " " + what);
}

void DropNonFinite(const std::filesystem::path& file, SceneMesh* mesh, ImportReport* report) {
  const std::size_t before = mesh->triangles.size();
  const std::size_t bad = Filter(mesh, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
      return mesh->positions[v].allFinite();
    });
  });
  if (static_cast<double>(bad) > kMaxBadShare * static_cast<double>(before)) {
    throw FileError(file, "",
                    std::to_string(bad) + " of " + std::to_string(before) +
                        " triangles have NaN or infinite corners; repair or export it again");
  }
  Note(bad, "triangles with NaN or infinite corners", report);
  for (Eigen::Vector2f& uv : mesh->uvs) {
    if (!uv.allFinite()) uv.setZero();
  }
}

/// Coordinate-wise median of the triangles' first corners.
Eigen::Vector3f MedianPoint(const SceneMesh& mesh) {
  Eigen::Vector3f median;
  std::vector<float> values(mesh.triangles.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = mesh.positions[mesh.triangles[i][0]][axis];
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[axis] = *middle;
  }
  return median;
}

float Reach(const SceneMesh& mesh, const Triangle& t, const Eigen::Vector3f& centre) {
  float reach = 0.0f;
  for (const std::uint32_t v : t) {
    reach = std::max(reach, (mesh.positions[v] - centre).cwiseAbs().maxCoeff());
  }
  return reach;
}

/// Scans carry stray specks kilometres away: beyond ten times where 99% of the triangles are.
void DropStray(SceneMesh* mesh, ImportReport* report) {
  if (mesh->triangles.empty()) return;
  const Eigen::Vector3f centre = MedianPoint(*mesh);
  std::vector<float> reaches;
  for (const Triangle& t : mesh->triangles) reaches.push_back(Reach(*mesh, t, centre));
  const auto nearly_all = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() * 99 / 100);
  std::nth_element(reaches.begin(), nearly_all, reaches.end());
  const float limit = std::max(kMinStrayDistance, kStrayFactor * *nearly_all);
  Note(Filter(mesh,
              [&](const Triangle& t) {
                return Reach(*mesh, t, centre) <= limit;
              }),
       "stray triangles far away", report);
}

void DropFlat(SceneMesh* mesh, ImportReport* report) {
  Note(Filter(mesh,
              [&](const Triangle& t) {
                const Eigen::Vector3f& a = mesh->positions[t[0]];
                const Eigen::Vector3f u = mesh->positions[t[1]] - a;
                const Eigen::Vector3f v = mesh->positions[t[2]] - a;
                return u.cross(v).norm() > kMinDoubleArea;
              }),
       "triangles without area", report);
}

/// The three corners of a triangle, in an order that does not depend on the winding.
using Corners = std::array<std::array<float, 3>, 3>;

struct CornersHash {
  std::size_t operator()(const Corners& corners) const {
    std::size_t hash = 0;
    for (const auto& corner : corners) {
      for (const float x : corner) hash = hash * 1000003 + std::hash<float>()(x);
    }
    return hash;
  }
};

void DropRepeated(SceneMesh* mesh, ImportReport* report) {
  std::unordered_set<Corners, CornersHash> seen;
  seen.reserve(mesh->triangles.size());
  Note(Filter(mesh,
              [&](const Triangle& t) {
                Corners corners;
                for (std::size_t k = 0; k < 3; ++k) {
                  const Eigen::Vector3f& p = mesh->positions[t[k]];
                  corners[k] = {p.x(), p.y(), p.z()};
                }
                std::sort(corners.begin(), corners.end());
                return seen.insert(corners).second;
              }),
       "repeated triangles", report);
}

void DropUnusedVertices(SceneMesh* mesh) {
  constexpr std::uint32_t kUnused = ~0u;
  std::vector<std::uint32_t> new_index(mesh->positions.size(), kUnused);
  for (const Triangle& t : mesh->triangles) {
    for (const std::uint32_t v : t) new_index[v] = 0;
  }
  std::uint32_t used = 0;
  for (std::size_t v = 0; v < new_index.size(); ++v) {
    if (new_index[v] == kUnused) continue;
    mesh->positions[used] = mesh->positions[v];
    mesh->uvs[used] = mesh->uvs[v];
    mesh->colors[used] = mesh->colors[v];
    new_index[v] = used++;
  }
  mesh->positions.resize(used);
  mesh->uvs.resize(used);
  mesh->colors.resize(used);
  for (Triangle& t : mesh->triangles) {
    for (std::uint32_t& v : t) v = new_index[v];
  }
}

void CheckExtent(const std::filesystem::path& file, const SceneMesh& mesh) {
  const Eigen::AlignedBox3f box = mesh.Bounds();
  const float extent = box.sizes().maxCoeff();
  const float offset = box.center().cwiseAbs().maxCoeff();
  if (extent < kMinExtent || extent > kMaxExtent) {
    throw FileError(
        file, "",
        fmt::format("is {:.3g} m wide, which no building is; if it is not in metres, give "
                    "--scale ({}; in a config: import.scale)",
                    extent, extent < kMinExtent ? "1000 for kilometres" : "0.001 for millimetres"));
  }
  if (offset <= kMaxOffset) return;
  throw FileError(file, "",
                  fmt::format("lies {:.3g} m from the origin, where single precision cannot place "
                              "a wall; move it there",
                              offset));
}

}  // namespace

void CleanMesh(const std::filesystem::path& file, SceneMesh* mesh, ImportReport* report) {
  DropNonFinite(file, mesh, report);
  DropStray(mesh, report);
  DropFlat(mesh, report);
  DropRepeated(mesh, report);
  if (mesh->triangles.empty()) {
    throw FileError(file, "", "holds no triangles; is it a point cloud or an empty export?");
  }
  CheckExtent(file, *mesh);
  DropUnusedVertices(mesh);
}

}  // namespace bulletnav::sim
