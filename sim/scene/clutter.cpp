// SPDX-License-Identifier: MIT
#include "sim/scene/clutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "sim/base/elementary.h"
#include "sim/math/rng.h"
#include "sim/scene/mesh_measures.h"

namespace bulletnav::sim {
namespace {

using Eigen::Vector3f;

constexpr double kOnTops = 0.4;     // of all pieces
constexpr double kLumps = 0.4;      // of all pieces
constexpr double kArea = 10.0;      // m2 that the density is for
constexpr float kUpright = 0.2f;    // vertical part of a wall's normal, at most
constexpr float kWallFoot = 0.3f;   // metres above the floor, at most
constexpr float kWallHead = 0.6f;   // at least
constexpr float kLowestTop = 0.3f;  // metres above the floor
constexpr float kHighestTop = 1.4f;
constexpr double kLeastTop = 0.02;  // m2
constexpr int kMostPieces = 3000;

/// Where a piece stands: the middle of its foot, and the directions of its sides.
struct Stand {
  Vector3f foot;
  Vector3f along;
  Vector3f across;
  Vector3f size;  // along, up, across
  Rgb8 color = kWhite;
};

/// Whether a point lies in a triangle seen along `normal`.
bool Covers(const SceneMesh& mesh, std::size_t t, const Vector3f& normal, const Vector3f& p) {
  const auto& corners = mesh.triangles[t];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3f& a = mesh.positions[corners[i]];
    const Vector3f& b = mesh.positions[corners[(i + 1) % corners.size()]];
    if (normal.dot((b - a).cross(p - a)) < 0.0f) return false;
  }
  return true;
}

class Clutterer {
 public:
  Clutterer(std::uint64_t seed, SceneMesh* mesh)
      : rng_(seed, "clutter"),
        mesh_(mesh),
        floor_(FloorHeight(*mesh)),
        count_(mesh->triangles.size()) {
    Survey();
  }

  void Add(double density) {
    const int pieces =
        std::min(kMostPieces, static_cast<int>(std::lround(density * floor_area_ / kArea)));
    for (int i = 0; i < pieces; ++i) {
      const auto stand = rng_.Chance(kOnTops) ? OnATop() : AtAWall();
      if (stand) Build(*stand);
    }
  }

 private:
  void Survey() {
    for (std::size_t t = 0; t < count_; ++t) {
      const Vector3f normal = NormalOf(*mesh_, t);
      const double area = AreaOf(*mesh_, t);
      const float foot = LowestOf(*mesh_, t) - floor_;
      if (IsOnTheFloor(*mesh_, t, floor_)) {
        floor_area_ += area;
      } else if (IsLevel(*mesh_, t)) {
        const bool is_top = normal.y() > 0.0f && foot > kLowestTop && foot < kHighestTop;
        if (is_top && area > kLeastTop) tops_.push_back(t);
      } else if (std::abs(normal.y()) < kUpright * normal.norm() && std::abs(foot) < kWallFoot &&
                 HighestOf(*mesh_, t) > floor_ + kWallHead) {
        walls_.push_back(t);
      }
    }
    level_ = ExactFloor(*mesh_, floor_);
    for (const std::size_t t : tops_) top_areas_.push_back(AreaOf(*mesh_, t));
    for (const std::size_t t : walls_) wall_areas_.push_back(AreaOf(*mesh_, t));
  }

  float Draw(double low, double high) { return static_cast<float>(rng_.Uniform(low, high)); }

  /// Evenly over a triangle.
  Vector3f PointOn(std::size_t t) {
    float u = Draw(0.0, 1.0);
    float v = Draw(0.0, 1.0);
    if (u + v > 1.0f) {
      u = 1.0f - u;
      v = 1.0f - v;
    }
    const auto& corners = mesh_->triangles[t];
    const Vector3f& a = mesh_->positions[corners[0]];
    return a + u * (mesh_->positions[corners[1]] - a) + v * (mesh_->positions[corners[2]] - a);
  }

  std::optional<Stand> OnATop() {
    if (tops_.empty()) return std::nullopt;
    const std::size_t t = tops_[rng_.Weighted(top_areas_)];
    const double turn = rng_.Uniform(0.0, 2.0 * std::numbers::pi);
    Stand stand;
    stand.foot = PointOn(t);
    stand.along = Vector3f(static_cast<float>(Cos(turn)), 0, static_cast<float>(Sin(turn)));
    stand.across = Vector3f(-stand.along.z(), 0, stand.along.x());
    const float width = Draw(0.05, 0.25);
    const float depth = Draw(0.05, 0.2);
    stand.size = Vector3f(width, Draw(0.05, 0.3), depth);
    stand.color = mesh_->colors[mesh_->triangles[t][0]];
    return stand;
  }

  /// Nothing where the wall does not reach down to the floor along the whole piece, as in doorways.
  std::optional<Stand> AtAWall() {
    constexpr int kTries = 20;
    constexpr float kCovered = 0.3f;  // metres above the floor where the wall must be
    if (walls_.empty()) return std::nullopt;
    for (int i = 0; i < kTries; ++i) {
      const std::size_t t = walls_[rng_.Weighted(wall_areas_)];
      const Vector3f normal = NormalOf(*mesh_, t);
      const float width = Draw(0.1, 0.4);
      const float depth = Draw(0.06, 0.2);
      const float height = Draw(0.05, 0.4);
      Stand stand;
      stand.across = Vector3f(normal.x(), 0, normal.z()).normalized();
      if (rng_.Chance(0.5)) stand.across = -stand.across;
      stand.along = Vector3f(stand.across.z(), 0, -stand.across.x());
      Vector3f at = PointOn(t);
      at.y() = level_ + kCovered;
      const Vector3f half = 0.5f * width * stand.along;
      if (!Covers(*mesh_, t, normal, at - half) || !Covers(*mesh_, t, normal, at + half)) continue;
      at.y() = level_;
      stand.foot = at + 0.5f * depth * stand.across;
      stand.size = Vector3f(width, height, depth);
      stand.color = mesh_->colors[mesh_->triangles[t][0]];
      return stand;
    }
    return std::nullopt;
  }

  /// A box, or a lump: a box with its corners moved.
  void Build(const Stand& stand) {
    const float jitter = rng_.Chance(kLumps) ? 0.3f : 0.0f;
    std::array<Vector3f, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const float x = (i & 1) != 0 ? 0.5f : -0.5f;
      const float y = (i & 2) != 0 ? 1.0f : 0.0f;
      const float z = (i & 4) != 0 ? 0.5f : -0.5f;
      // Inwards alone.
      const float narrower = 1.0f - jitter * Draw(0.0, 1.0) - y * jitter;
      corners[i] = stand.foot + x * narrower * stand.size.x() * stand.along +
                   y * (1.0f - jitter * Draw(0.0, 1.0)) * stand.size.y() * Vector3f::UnitY() +
                   z * narrower * stand.size.z() * stand.across;
    }
    const std::uint32_t material =
        mesh_->triangle_materials[static_cast<std::size_t>(rng_.Below(static_cast<int>(count_)))];
    if (mesh_->has_objects()) {
      mesh_->objects.push_back({"clutter", "clutter_" + std::to_string(++built_), ""});
    }
    struct Side {
      std::array<std::size_t, 4> corners;
      int light;  // tenths
    };
    constexpr std::array<Side, 5> kSides = {{{{2, 6, 7, 3}, 10},
                                             {{0, 2, 3, 1}, 9},
                                             {{4, 5, 7, 6}, 8},
                                             {{0, 4, 6, 2}, 7},
                                             {{1, 3, 7, 5}, 8}}};
    for (const Side& side : kSides) {
      AddSide({corners[side.corners[0]], corners[side.corners[1]], corners[side.corners[2]],
               corners[side.corners[3]]},
              material, Lit(stand.color, side.light));
    }
  }

  static Rgb8 Lit(Rgb8 color, int tenths) {
    for (auto& value : color) value = static_cast<std::uint8_t>(value * tenths / 10);
    return color;
  }

  void AddSide(const std::array<Vector3f, 4>& corners, std::uint32_t material, const Rgb8& color) {
    const auto first = static_cast<std::uint32_t>(mesh_->positions.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      mesh_->positions.push_back(corners[i]);
      // A metre is a texture's side.
      const float u = i >= 2 ? (corners[2] - corners[1]).norm() : 0.0f;
      const float v = i == 1 || i == 2 ? (corners[1] - corners[0]).norm() : 0.0f;
      mesh_->uvs.emplace_back(u, v);
      mesh_->colors.push_back(color);
    }
    mesh_->triangles.push_back({first, first + 1, first + 2});
    mesh_->triangles.push_back({first, first + 2, first + 3});
    mesh_->triangle_materials.insert(mesh_->triangle_materials.end(), 2, material);
    if (!mesh_->has_objects()) return;
    const auto object = static_cast<std::uint32_t>(mesh_->objects.size()) - 1;
    mesh_->triangle_objects.insert(mesh_->triangle_objects.end(), 2, object);
  }

  Rng rng_;
  SceneMesh* mesh_;
  float floor_;
  std::size_t count_;  // of the scene's own triangles
  int built_ = 0;
  float level_ = 0.0f;
  double floor_area_ = 0.0;
  std::vector<std::size_t> tops_;
  std::vector<std::size_t> walls_;
  std::vector<double> top_areas_;
  std::vector<double> wall_areas_;
};

}  // namespace

void AddClutter(double density, std::uint64_t seed, SceneMesh* mesh) {
  if (density > 0.0) Clutterer(seed, mesh).Add(density);
}

}  // namespace bulletnav::sim
