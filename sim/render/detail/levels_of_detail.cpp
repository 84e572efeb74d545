// SPDX-License-Identifier: MIT
#include "sim/render/detail/levels_of_detail.h"

#include <array>

#include "sim/render/detail/coarse_patch.h"

namespace bulletnav::sim {
namespace {

/// Parts of the hierarchy with at most so many triangles get a coarse copy.
struct Level {
  std::size_t triangles;
  double largest_error;  // metres
};

// Larger patches have fewer borders, which stay as they are, for their area, and are larger than
// what is near.
constexpr std::array<Level, 2> kLevels = {{{512, 0.01}, {8192, 0.03}}};
constexpr std::size_t kFewest = 64;  // triangles that are worth a copy

class DetailMaker {
 public:
  DetailMaker(const SceneMesh& scene, RenderMesh* mesh, Bvh* bvh)
      : scene_(scene), mesh_(*mesh), bvh_(*bvh) {}

  void Run() { Visit(0, kLevels.size()); }

 private:
  using Triangles = std::vector<std::uint32_t>;

  /// Adds copies below a node whose own triangles are too many for all levels from `level` on.
  /// Returns the triangles below it.
  Triangles Visit(std::int32_t node, std::size_t level) {
    Triangles all;
    const std::int32_t count = bvh_.nodes[static_cast<std::size_t>(node)].count;
    for (std::int32_t i = 0; i < count; ++i) {
      const std::int32_t child = bvh_.nodes[static_cast<std::size_t>(node)].child[i];
      const Triangles below = child < 0 ? OfLeaf(LeafAt(child)) : VisitChild(node, i, level);
      all.insert(all.end(), below.begin(), below.end());
    }
    return all;
  }

  Triangles VisitChild(std::int32_t node, std::int32_t i, std::size_t level) {
    const std::int32_t child = bvh_.nodes[static_cast<std::size_t>(node)].child[i];
    const std::size_t size = Count(child);
    std::size_t below = level;
    while (below > 0 && size <= kLevels[below - 1].triangles) --below;
    Triangles triangles = Visit(child, below);
    // The coarsest level that it is small enough for and its parent is not.
    if (below < level && triangles.size() >= kFewest) {
      const std::int32_t detail = Detail(child, triangles, kLevels[level - 1].largest_error);
      bvh_.nodes[static_cast<std::size_t>(node)].child[i] = detail;
    }
    return triangles;
  }

  std::size_t Count(std::int32_t reference) const {
    if (reference < 0) {
      return static_cast<std::size_t>(LeafAt(reference).count);
    }
    const BvhNode& node = bvh_.nodes[static_cast<std::size_t>(reference)];
    std::size_t count = 0;
    for (std::int32_t i = 0; i < node.count; ++i) count += Count(node.child[i]);
    return count;
  }

  const BvhLeaf& LeafAt(std::int32_t reference) const {
    const std::int32_t number = ~reference;
    return bvh_.leaves[static_cast<std::size_t>(number)];
  }

  static Triangles OfLeaf(const BvhLeaf& leaf) { return {leaf.id, leaf.id + leaf.count}; }

  /// A node that offers `node` or a coarse copy of its triangles; `node` if there is none.
  std::int32_t Detail(std::int32_t node, const Triangles& triangles, double largest_error) {
    const auto patch = Simplified(scene_, triangles, largest_error);
    if (!patch) return node;
    const std::size_t first = mesh_.corners.size();
    for (std::size_t t = 0; t < patch->triangles.size(); ++t) {
      mesh_.Add(scene_, patch->triangles[t], patch->like[t]);
    }
    const std::int32_t coarse = bvh_.Graft(mesh_.corners, first);
    return bvh_.AddDetail(node, coarse, static_cast<float>(patch->error));
  }

  const SceneMesh& scene_;
  RenderMesh& mesh_;
  Bvh& bvh_;
};

}  // namespace

void AddLevelsOfDetail(const SceneMesh& scene, RenderMesh* mesh, Bvh* bvh) {
  DetailMaker(scene, mesh, bvh).Run();
}

}  // namespace bulletnav::sim
