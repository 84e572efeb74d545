// SPDX-License-Identifier: MIT
#include "sim/scene/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "sim/scene/mesh_measures.h"

namespace bulletnav::sim {
namespace {

constexpr int kMostPasses = 12;
constexpr std::size_t kMostTriangles = 2'000'000;
constexpr double kManyTriangles = 120'000.0;
constexpr double kTriangleArea = 0.1;  // of one with edges up to 1, as halving leaves them

using Triangle = std::array<std::uint32_t, 3>;

/// Cuts triangles pass by pass. One that was left as it is in a pass stays so in all later ones.
class Refiner {
 public:
  Refiner(const SplitsEdge& splits, SceneMesh* mesh)
      : splits_(splits), mesh_(mesh), open_(mesh->triangles.size()) {
    std::iota(open_.begin(), open_.end(), std::size_t{0});
  }

  /// False if there was nothing to cut.
  bool Pass() {
    std::vector<std::size_t> next;
    for (const std::size_t t : open_) {
      const std::size_t first = mesh_->triangles.size();
      if (!Cut(t)) continue;
      next.push_back(t);
      for (std::size_t added = first; added < mesh_->triangles.size(); ++added) {
        next.push_back(added);
      }
    }
    open_ = std::move(next);
    return !open_.empty();
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// The vertex in an edge's middle, kNone if the edge is not cut.
  std::uint32_t MiddleOf(std::uint32_t material, std::uint32_t a, std::uint32_t b) {
    const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
    const auto found = middles_.find(key);
    if (found != middles_.end()) return found->second;
    if (!splits_(material, mesh_->positions[a], mesh_->positions[b])) return kNone;
    return middles_[key] = AddMiddle(a, b);
  }

  std::uint32_t AddMiddle(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t middle = CopyVertex(a, mesh_);
    mesh_->positions[middle] = 0.5f * (mesh_->positions[a] + mesh_->positions[b]);
    mesh_->uvs[middle] = 0.5f * (mesh_->uvs[a] + mesh_->uvs[b]);
    for (std::size_t c = 0; c < 3; ++c) {
      mesh_->colors[middle][c] =
          static_cast<std::uint8_t>((mesh_->colors[a][c] + mesh_->colors[b][c] + 1) / 2);
    }
    return middle;
  }

  bool Cut(std::size_t t) {
    const std::uint32_t material = mesh_->triangle_materials[t];
    Triangle corner = mesh_->triangles[t];
    Triangle middle{};  // of the edge from corner i to the next one
    for (std::size_t i = 0; i < 3; ++i) {
      middle[i] = MiddleOf(material, corner[i], corner[(i + 1) % 3]);
    }
    const auto cuts = 3 - std::count(middle.begin(), middle.end(), kNone);
    if (cuts == 0) return false;
    // The first edge is one that is cut, and of two cut ones the second follows it.
    while (middle[0] == kNone || (cuts == 2 && middle[1] == kNone)) {
      std::rotate(corner.begin(), corner.begin() + 1, corner.end());
      std::rotate(middle.begin(), middle.begin() + 1, middle.end());
    }
    if (cuts == 1) {
      mesh_->triangles[t] = {corner[0], middle[0], corner[2]};
      AddTriangleLike(t, {middle[0], corner[1], corner[2]}, mesh_);
      return true;
    }
    mesh_->triangles[t] = {middle[0], corner[1], middle[1]};
    if (cuts == 2) {
      AddTriangleLike(t, {corner[0], middle[0], middle[1]}, mesh_);
      AddTriangleLike(t, {corner[0], middle[1], corner[2]}, mesh_);
      return true;
    }
    AddTriangleLike(t, {corner[0], middle[0], middle[2]}, mesh_);
    AddTriangleLike(t, {middle[2], middle[1], corner[2]}, mesh_);
    AddTriangleLike(t, {middle[0], middle[1], middle[2]}, mesh_);
    return true;
  }

  const SplitsEdge& splits_;
  SceneMesh* mesh_;
  std::vector<std::size_t> open_;                             // triangles that may have to be cut
  std::unordered_map<std::uint64_t, std::uint32_t> middles_;  // by the edge's ends
};

}  // namespace

void Refine(const SplitsEdge& splits, SceneMesh* mesh) {
  Refiner refiner(splits, mesh);
  for (int i = 0; i < kMostPasses && mesh->triangles.size() < kMostTriangles; ++i) {
    if (!refiner.Pass()) return;
  }
}

double AffordableEdge(const SceneMesh& mesh) {
  return std::sqrt(AreaOf(mesh) / (kTriangleArea * kManyTriangles));
}

void RefineTo(double longest, SceneMesh* mesh) {
  const auto limit = static_cast<float>(std::max(longest, AffordableEdge(*mesh)));
  Refine(
      [limit](std::uint32_t, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
        return (a - b).squaredNorm() > limit * limit;
      },
      mesh);
}

double AreaOf(const SceneMesh& mesh) {
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += AreaOf(mesh, t);
  return area;
}

}  // namespace bulletnav::sim
