// SPDX-License-Identifier: MIT
#include "benchmark/perf/subdivide.h"

#include <map>

#include <gtest/gtest.h>

#include "sim/scene/refine.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

/// A tetrahedron: closed, with shared vertices.
sim::SceneMesh Tetrahedron() {
  sim::SceneMesh mesh;
  mesh.materials = {{"grey", {128, 128, 128}, -1}};
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  mesh.uvs.assign(4, Eigen::Vector2f::Zero());
  mesh.colors.assign(4, sim::kWhite);
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  mesh.triangle_materials.assign(4, 0);
  return mesh;
}

TEST(Subdivided, IsTheSameSurfaceInAboutAsManyTriangles) {
  for (const sim::SceneMesh& mesh : {Tetrahedron(), tests::BoxRoom(4, 3, 5)}) {
    for (const std::size_t count : {1, 50, 1000, 4096, 10000}) {
      const sim::SceneMesh fine = Subdivided(mesh, count);
      fine.Validate();
      EXPECT_NEAR(sim::AreaOf(fine), sim::AreaOf(mesh), 1e-3);
      EXPECT_GE(fine.triangles.size(), count);
      EXPECT_LE(fine.triangles.size(), std::max(mesh.triangles.size(), count + count / 50 + 12));
    }
  }
}

TEST(Subdivided, EdgesFit) {
  const sim::SceneMesh fine = Subdivided(Tetrahedron(), 777);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;  // of directed edges
  for (const auto& corners : fine.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++sides[{corners[k], corners[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(sides.count({edge.second, edge.first}), 1u);
  }
}

}  // namespace
}  // namespace bulletnav::bench
