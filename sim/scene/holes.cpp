// SPDX-License-Identifier: MIT
#include "sim/scene/holes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/scene/glass.h"
#include "sim/scene/mesh_measures.h"
#include "sim/scene/patches.h"
#include "sim/scene/refine.h"
#include "sim/scene/smooth_noise.h"

namespace bulletnav::sim {
namespace {

constexpr float kOverhead = 2.0f;  // metres above the floor
// How much sooner than others these have a hole; the noise is between -1.34 and 1.34.
constexpr float kShiny = 0.5f;
constexpr float kDark = 0.4f;  // black; less for what is less dark
constexpr float kCeiling = 0.15f;
constexpr double kFinest = 0.05;     // metres
constexpr double kAffordable = 0.4;  // of AffordableEdge: only a part of the mesh is cut so finely
constexpr double kEdgesAcross = 4.0;

std::vector<float> ReadinessOf(const SceneMesh& mesh) {
  std::vector<float> readiness;
  for (const Material& material : mesh.materials) {
    const auto mean = MeanOf(mesh, material);
    const double light = (mean[0] + mean[1] + mean[2]) / (3.0 * 255.0);
    const float shine = IsShiny(material.name) ? kShiny : 0.0f;
    readiness.push_back(shine + kDark * static_cast<float>(1.0 - light));
  }
  return readiness;
}

/// Takes triangles out by their values, unless nothing would be left.
void RemoveAbove(float threshold, const std::vector<float>& values, SceneMesh* mesh) {
  std::vector<char> kept(values.size());
  std::transform(values.begin(), values.end(), kept.begin(), [threshold](float value) {
    return static_cast<char>(value > threshold ? 0 : 1);
  });
  if (std::count(kept.begin(), kept.end(), 1) > 0) KeepTriangles(kept, mesh);
}

class HolePuncher {
 public:
  HolePuncher(const Holes& holes, std::uint64_t seed, SceneMesh* mesh)
      : holes_(holes),
        noise_(seed, holes.size),
        mesh_(mesh),
        floor_(FloorHeight(*mesh)),
        readiness_(ReadinessOf(*mesh)) {}

  void Run() {
    RefineTo(0.75 * holes_.size, mesh_);
    Measure();
    RefineBorders();
    Measure();
    RemoveAbove(threshold_, values_, mesh_);
  }

 private:
  void Measure() {
    values_.clear();
    std::vector<double> areas;
    for (std::size_t t = 0; t < mesh_->triangles.size(); ++t) {
      const bool may_go = holes_.floors || !IsOnTheFloor(*mesh_, t, floor_);
      const bool is_ceiling = LowestOf(*mesh_, t) > floor_ + kOverhead && IsLevel(*mesh_, t);
      const float value = noise_.RoughAt(CentreOf(*mesh_, t)) + (is_ceiling ? kCeiling : 0.0f) +
                          readiness_[mesh_->triangle_materials[t]];
      values_.push_back(may_go ? value : -HUGE_VALF);
      areas.push_back(may_go ? AreaOf(*mesh_, t) : 0.0);
    }
    threshold_ = ThresholdOf(values_, areas, holes_.share);
  }

  /// So that holes are rounder than the triangles.
  void RefineBorders() {
    const auto finest = static_cast<float>(
        std::max({kFinest, holes_.size / kEdgesAcross, kAffordable * AffordableEdge(*mesh_)}));
    Refine(
        [&](std::uint32_t material, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
          if ((a - b).squaredNorm() <= finest * finest) return false;
          const float level = threshold_ - readiness_[material];
          const bool at_a = noise_.RoughAt(a) > level;
          return at_a != (noise_.RoughAt(b) > level) ||
                 at_a != (noise_.RoughAt(0.5f * (a + b)) > level);
        },
        mesh_);
  }

  Holes holes_;
  SmoothNoise noise_;
  SceneMesh* mesh_;
  float floor_;
  std::vector<float> readiness_;  // by material
  std::vector<float> values_;     // by triangle
  float threshold_ = 0.0f;
};

void OpenFloor(double share, std::uint64_t seed, float floor, SceneMesh* mesh) {
  constexpr double kSize = 0.25;         // metres from gap to gap
  constexpr double kEdge = 0.12;         // metres
  constexpr float kNearTheFloor = 0.2f;  // metres
  const auto edge = static_cast<float>(std::max(kEdge, kAffordable * AffordableEdge(*mesh)));
  Refine(
      [&](std::uint32_t, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
        return std::abs(a.y() - floor) < kNearTheFloor && std::abs(b.y() - floor) < kNearTheFloor &&
               (a - b).squaredNorm() > edge * edge;
      },
      mesh);
  const SmoothNoise noise(seed, kSize);
  std::vector<float> values;
  std::vector<double> areas;
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    const bool is_floor = IsOnTheFloor(*mesh, t, floor);
    values.push_back(is_floor ? noise.RoughAt(CentreOf(*mesh, t)) : -HUGE_VALF);
    areas.push_back(is_floor ? AreaOf(*mesh, t) : 0.0);
  }
  const float threshold = ThresholdOf(values, areas, share);
  RemoveAbove(threshold, values, mesh);
}

/// A copy of a vertex below a level, and darker.
std::uint32_t Reflected(std::uint32_t vertex, float level, SceneMesh* mesh) {
  constexpr int kLight = 6;  // tenths
  const std::uint32_t copy = CopyVertex(vertex, mesh);
  Eigen::Vector3f& p = mesh->positions[copy];
  p.y() = 2.0f * level - p.y();
  for (auto& value : mesh->colors[copy]) value = static_cast<std::uint8_t>(value * kLight / 10);
  return copy;
}

void AddMirrored(float floor, float level, SceneMesh* mesh) {
  constexpr float kHighest = 3.0f;
  const std::size_t count = mesh->triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    if (IsOnTheFloor(*mesh, t, floor) || HighestOf(*mesh, t) < level) continue;
    if (LowestOf(*mesh, t) > level + kHighest) continue;
    std::array<std::uint32_t, 3> corners = mesh->triangles[t];
    for (std::uint32_t& corner : corners) corner = Reflected(corner, level, mesh);
    std::swap(corners[1], corners[2]);
    AddTriangleLike(t, corners, mesh);
  }
}

}  // namespace

void PunchHoles(const Holes& holes, std::uint64_t seed, SceneMesh* mesh) {
  if (holes.share > 0.0) HolePuncher(holes, seed, mesh).Run();
}

void MirrorFloor(double share, std::uint64_t seed, SceneMesh* mesh) {
  constexpr float kDeepest = 1.0f;
  const float floor = FloorHeight(*mesh);
  if (share <= 0.0 || mesh->Bounds().min().y() < floor - kDeepest) return;
  const float level = ExactFloor(*mesh, floor);
  AddMirrored(floor, level, mesh);
  OpenFloor(share, seed, floor, mesh);
}

}  // namespace bulletnav::sim
