// SPDX-License-Identifier: MIT
#include "sim/render/detail/coarse_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <meshoptimizer.h>

#include "sim/math/segment_triangle.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3d;
using Corners = std::array<std::uint32_t, 3>;

constexpr double kLeastChange = 6.0;  // of 255, of a vertex's colour: what can be seen
constexpr double kHill = 0.02;        // metres that stand for it

/// What makes a vertex the same as another: position and texture coordinates, and the colour.
using VertexKey = std::pair<std::array<float, 5>, Rgb8>;

/// A part of a patch with one material and one object; vertices that are the same are one.
struct Part {
  std::vector<Corners> triangles;        // indices into vertices
  std::vector<std::uint32_t> vertices;   // the mesh's
  std::vector<std::uint32_t> originals;  // the mesh's triangles
};

VertexKey KeyOf(const SceneMesh& mesh, std::uint32_t v) {
  const Eigen::Vector3f& p = mesh.positions[v];
  const Eigen::Vector2f& uv = mesh.uvs[v];
  return {{p.x(), p.y(), p.z(), uv.x(), uv.y()}, mesh.colors[v]};
}

Part Welded(const SceneMesh& mesh, std::vector<std::uint32_t> triangles) {
  Part part;
  part.originals = std::move(triangles);
  std::map<VertexKey, std::uint32_t> known;
  for (const std::uint32_t t : part.originals) {
    Corners corners{};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t v = mesh.triangles[t][k];
      const auto [found, is_new] =
          known.try_emplace(KeyOf(mesh, v), static_cast<std::uint32_t>(part.vertices.size()));
      if (is_new) part.vertices.push_back(v);
      corners[k] = found->second;
    }
    part.triangles.push_back(corners);
  }
  return part;
}

std::vector<Part> PartsOf(const SceneMesh& mesh, std::span<const std::uint32_t> triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> by_kind;
  for (const std::uint32_t t : triangles) {
    by_kind[{mesh.triangle_materials[t], mesh.has_objects() ? mesh.triangle_objects[t] : 0}]
        .push_back(t);
  }
  std::vector<Part> parts;
  for (auto& [kind, those] : by_kind) {
    std::sort(those.begin(), those.end());
    parts.push_back(Welded(mesh, std::move(those)));
  }
  return parts;
}

/// Where the vertices are, moved out of the surface by how light they are: the simplifier knows
/// shapes alone, and keeps light as it keeps hills. A change that can be seen is `hill` metres
/// high.
std::vector<Eigen::Vector3f> LightAsHills(const SceneMesh& mesh, const Part& part, double hill) {
  std::vector<Eigen::Vector3f> normals(part.vertices.size(), Eigen::Vector3f::Zero());
  for (const Corners& corners : part.triangles) {
    const auto at = [&](std::size_t k) {
      return mesh.positions[part.vertices[corners[k]]];
    };
    const Eigen::Vector3f normal = (at(1) - at(0)).cross(at(2) - at(0));
    for (const std::uint32_t corner : corners) normals[corner] += normal;
  }
  const auto height = static_cast<float>(hill / kLeastChange / 3.0);
  std::vector<Eigen::Vector3f> positions;
  for (std::size_t i = 0; i < part.vertices.size(); ++i) {
    const Rgb8& color = mesh.colors[part.vertices[i]];
    const auto light = static_cast<float>(color[0] + color[1] + color[2]);
    positions.push_back(mesh.positions[part.vertices[i]] +
                        height * light * normals[i].stableNormalized());
  }
  return positions;
}

std::vector<Corners> Simplify(const SceneMesh& mesh, const Part& part, double largest_error) {
  const std::vector<Eigen::Vector3f> positions = LightAsHills(mesh, part, kHill);
  const float* place = positions.front().data();
  const float scale = meshopt_simplifyScale(place, positions.size(), sizeof(Eigen::Vector3f));
  if (!(scale > 0.0f)) return part.triangles;
  std::vector<Corners> coarse(part.triangles.size());
  const std::size_t indices =
      meshopt_simplify(coarse.front().data(), part.triangles.front().data(),
                       3 * part.triangles.size(), place, positions.size(), sizeof(Eigen::Vector3f),
                       0, static_cast<float>(largest_error) / scale, meshopt_SimplifyLockBorder);
  coarse.resize(indices / 3);
  return coarse;
}

/// A coarse triangle, ready to be compared with.
struct Surface {
  Triangle3d corners;
  Vec low;
  Vec high;
  Corners vertices{};          // of the part
  double metres_per_uv = 0.0;  // 0 without a texture
};

/// How far the vertices of a part lie from its coarse triangles.
class ErrorOf {
 public:
  ErrorOf(const SceneMesh& mesh, const Part& part, const std::vector<Corners>& coarse)
      : mesh_(mesh), part_(part) {
    const bool is_textured =
        mesh.materials[mesh.triangle_materials[part.originals.front()]].texture >= 0;
    for (const Corners& corners : coarse) surfaces_.push_back(MakeSurface(corners, is_textured));
  }

  /// Metres; infinite where a colour changes too much.
  double Largest() const {
    double largest = 0.0;
    for (std::uint32_t v = 0; v < part_.vertices.size(); ++v) {
      largest = std::max(largest, OfVertex(part_.vertices[v]));
    }
    return largest;
  }

 private:
  Surface MakeSurface(const Corners& corners, bool is_textured) const {
    Surface surface;
    surface.vertices = corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      surface.corners[k] = mesh_.positions[part_.vertices[corners[k]]].cast<double>();
    }
    const auto& [a, b, c] = surface.corners;
    surface.low = a.cwiseMin(b).cwiseMin(c);
    surface.high = a.cwiseMax(b).cwiseMax(c);
    if (!is_textured) return surface;
    const Eigen::Vector2d u = UvOf(corners[1]) - UvOf(corners[0]);
    const Eigen::Vector2d v = UvOf(corners[2]) - UvOf(corners[0]);
    const double uv_area = std::abs(u.x() * v.y() - u.y() * v.x());
    if (uv_area > 0.0) surface.metres_per_uv = std::sqrt((b - a).cross(c - a).norm() / uv_area);
    return surface;
  }

  Eigen::Vector2d UvOf(std::uint32_t v) const {
    return mesh_.uvs[part_.vertices[v]].cast<double>();
  }

  double OfVertex(std::uint32_t v) const {
    const Vec p = mesh_.positions[v].cast<double>();
    double nearest = std::numeric_limits<double>::infinity();
    double error = nearest;
    for (const Surface& surface : surfaces_) {
      const Vec outside = (surface.low - p).cwiseMax(p - surface.high).cwiseMax(0.0);
      if (outside.norm() > nearest) continue;
      const ClosestPoints points = PointToTriangle(p, surface.corners);
      const double here = std::max(points.distance, Shift(surface, points.on_b, v));
      // Of two triangles on whose edge it lies, the one that looks right.
      if (points.distance < nearest || (points.distance == nearest && here < error)) error = here;
      nearest = std::min(nearest, points.distance);
    }
    return error;
  }

  /// By how many metres the texture at a point is not that of a vertex; infinite if the colour is
  /// another.
  double Shift(const Surface& surface, const Vec& at, std::uint32_t v) const {
    const std::array<double, 3> weights = Weights(surface.corners, at);
    Eigen::Vector2d uv = Eigen::Vector2d::Zero();
    Vec color = Vec::Zero();
    for (std::size_t k = 0; k < weights.size(); ++k) {
      uv += weights[k] * UvOf(surface.vertices[k]);
      color += weights[k] * ColorOf(part_.vertices[surface.vertices[k]]);
    }
    if ((color - ColorOf(v)).cwiseAbs().maxCoeff() > kLeastChange) {
      return std::numeric_limits<double>::infinity();
    }
    return surface.metres_per_uv * (uv - mesh_.uvs[v].cast<double>()).norm();
  }

  Vec ColorOf(std::uint32_t v) const {
    const Rgb8& color = mesh_.colors[v];
    return {1.0 * color[0], 1.0 * color[1], 1.0 * color[2]};
  }

  static std::array<double, 3> Weights(const Triangle3d& corners, const Vec& p) {
    const auto& [a, b, c] = corners;
    const Vec normal = (b - a).cross(c - a);
    const double squared = normal.squaredNorm();
    if (!(squared > 0.0)) return {1.0, 0.0, 0.0};
    const double second = (c - p).cross(a - p).dot(normal) / squared;
    const double third = (a - p).cross(b - p).dot(normal) / squared;
    return {1.0 - second - third, second, third};
  }

  const SceneMesh& mesh_;
  const Part& part_;
  std::vector<Surface> surfaces_;
};

void Add(const Part& part, const std::vector<Corners>& triangles, CoarsePatch* out) {
  for (const Corners& corners : triangles) {
    out->triangles.push_back(
        {part.vertices[corners[0]], part.vertices[corners[1]], part.vertices[corners[2]]});
    out->like.push_back(part.originals.front());
  }
}

/// A part's triangles, fewer or as they were.
struct CoarsePart {
  std::vector<Corners> triangles;
  double error = 0.0;
};

/// The simplifier's errors are means of a kind: what it takes out too boldly it is asked for again,
/// more carefully.
CoarsePart BestOf(const SceneMesh& mesh, const Part& part, double largest_error) {
  for (const double care : {1.0, 0.25, 0.05}) {
    std::vector<Corners> coarse = Simplify(mesh, part, care * largest_error);
    if (coarse.empty() || 2 * coarse.size() > part.triangles.size()) break;
    const double error = ErrorOf(mesh, part, coarse).Largest();
    if (error <= largest_error) return {std::move(coarse), error};
  }
  return {part.triangles, 0.0};
}

}  // namespace

std::optional<CoarsePatch> Simplified(const SceneMesh& mesh,
                                      std::span<const std::uint32_t> triangles,
                                      double largest_error) {
  CoarsePatch patch;
  for (const Part& part : PartsOf(mesh, triangles)) {
    const CoarsePart coarse = BestOf(mesh, part, largest_error);
    Add(part, coarse.triangles, &patch);
    patch.error = std::max(patch.error, coarse.error);
  }
  if (2 * patch.triangles.size() > triangles.size()) return std::nullopt;
  return patch;
}

}  // namespace bulletnav::sim
