// SPDX-License-Identifier: MIT
#include "sim/house/hidden.h"

#include <algorithm>
#include <cmath>

#include "sim/house/hemisphere.h"
#include "sim/render/cpu/ray_tracer.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

constexpr float kClose = 0.08f;    // metres
constexpr int kMostFree = 2;       // of 16 directions
constexpr float kLift = 0.0015f;   // above the surface
constexpr float kInward = 0.012f;  // from the edges, about
constexpr float kSpacing = 0.12f;  // between the points looked at, metres

/// Looks out from points of a triangle's front.
class Looker {
 public:
  explicit Looker(const SceneMesh& mesh) : mesh_(mesh), scene_(Corners(mesh)) {}

  bool IsHidden(const std::array<std::uint32_t, 3>& triangle) const {
    std::array<Vec, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh_.positions[triangle[k]];
    const Vec normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    float longest = 0.0f;
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, (corners[k] - corners[(k + 1) % 3]).norm());
    }
    // Points spread evenly over the triangle, drawn in a little from its edges.
    const int steps = 1 + static_cast<int>(std::ceil(longest / kSpacing));
    const float shrink = 1.0f - std::min(0.3f, 3.0f * kInward / longest);
    const Vec middle = (corners[0] + corners[1] + corners[2]) / 3.0f;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        const float a = static_cast<float>(i) / static_cast<float>(steps);
        const float b = static_cast<float>(j) / static_cast<float>(steps);
        const Vec point =
            corners[0] + a * (corners[1] - corners[0]) + b * (corners[2] - corners[0]);
        if (!IsClosedIn(middle + shrink * (point - middle), normal)) return false;
      }
    }
    return true;
  }

 private:
  static std::vector<std::array<Vec, 3>> Corners(const SceneMesh& mesh) {
    std::vector<std::array<Vec, 3>> corners;
    for (const auto& [a, b, c] : mesh.triangles) {
      corners.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
    }
    return corners;
  }

  bool IsClosedIn(const Vec& point, const Vec& normal) const {
    int free = 0;
    CastHemisphere(scene_, directions_, 0, point + kLift * normal, normal,
                   [&](const RayHit& hit, const Vec&) {
                     if (hit.triangle < 0 || hit.t > kClose) ++free;
                   });
    return free <= kMostFree;
  }

  const SceneMesh& mesh_;
  RayTracer scene_;
  const std::array<Vec, 16> directions_ = HemisphereDirections<16>();
};

/// Drops the vertices that no triangle uses.
void Compact(SceneMesh* mesh) {
  constexpr std::uint32_t kUnused = ~0u;
  std::vector<std::uint32_t> place(mesh->positions.size(), kUnused);
  std::uint32_t count = 0;
  for (auto& triangle : mesh->triangles) {
    for (std::uint32_t& v : triangle) {
      if (place[v] == kUnused) place[v] = count++;
      v = place[v];
    }
  }
  SceneMesh kept = *mesh;
  kept.positions.resize(count);
  kept.uvs.resize(count);
  kept.colors.resize(count);
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] == kUnused) continue;
    kept.positions[place[v]] = mesh->positions[v];
    kept.uvs[place[v]] = mesh->uvs[v];
    kept.colors[place[v]] = mesh->colors[v];
  }
  *mesh = std::move(kept);
}

}  // namespace

std::size_t RemoveHidden(SceneMesh* mesh, std::vector<Glow>* glows) {
  const Looker looker(*mesh);
  std::vector<char> hidden;
  for (const auto& triangle : mesh->triangles) hidden.push_back(looker.IsHidden(triangle) ? 1 : 0);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < hidden.size(); ++t) {
    if (hidden[t] != 0) continue;
    mesh->triangles[kept] = mesh->triangles[t];
    mesh->triangle_materials[kept] = mesh->triangle_materials[t];
    if (mesh->has_objects()) mesh->triangle_objects[kept] = mesh->triangle_objects[t];
    (*glows)[kept] = (*glows)[t];
    ++kept;
  }
  mesh->triangles.resize(kept);
  mesh->triangle_materials.resize(kept);
  if (mesh->has_objects()) mesh->triangle_objects.resize(kept);
  glows->resize(kept);
  Compact(mesh);
  return hidden.size() - kept;
}

}  // namespace bulletnav::sim
