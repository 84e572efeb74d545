// SPDX-License-Identifier: MIT
#include "sim/house/refine.h"

#include <map>
#include <numeric>
#include <tuple>

#include <gtest/gtest.h>

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

/// An octahedron around the origin, its corners shared or each face with its own; uv = (x, y).
SceneMesh Octahedron(bool shared) {
  const std::array<Vec, 6> corners = {Vec(1, 0, 0),  Vec(-1, 0, 0), Vec(0, 1, 0),
                                      Vec(0, -1, 0), Vec(0, 0, 1),  Vec(0, 0, -1)};
  const std::array<std::array<std::uint32_t, 3>, 8> faces = {
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  SceneMesh mesh;
  const auto add = [&](const Vec& p) {
    mesh.positions.push_back(p);
    mesh.uvs.emplace_back(p.x(), p.y());
    mesh.colors.push_back({static_cast<std::uint8_t>(100 + 100 * p.x()), 0, 0});
    return static_cast<std::uint32_t>(mesh.positions.size()) - 1;
  };
  if (shared) {
    for (const Vec& p : corners) add(p);
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = faces[i];
    if (shared) {
      mesh.triangles.push_back(faces[i]);
    } else {
      mesh.triangles.push_back({add(corners[a]), add(corners[b]), add(corners[c])});
    }
    mesh.triangle_materials.push_back(static_cast<std::uint32_t>(i));
  }
  return mesh;
}

std::vector<int> Numbers(const SceneMesh& mesh) {
  std::vector<int> numbers(mesh.triangles.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

Vec AreaVector(const SceneMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vec& p = mesh.positions[a];
  return 0.5f * (mesh.positions[b] - p).cross(mesh.positions[c] - p);
}

/// Uneven on purpose, so that triangles with one, two and three halved edges occur.
std::function<bool(std::uint32_t, std::uint32_t)> LongEdges(const SceneMesh& mesh) {
  return [&mesh](std::uint32_t a, std::uint32_t b) {
    const Vec middle = 0.5f * (mesh.positions[a] + mesh.positions[b]);
    const float limit = 0.1f + 0.3f * std::abs(middle.x() + 0.3f * middle.y());
    return (mesh.positions[a] - mesh.positions[b]).norm() > limit;
  };
}

using Edge = std::array<float, 6>;

Edge EdgeOf(const Vec& p, const Vec& q) {
  return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z()};
}

class RefineTest : public testing::TestWithParam<bool> {};

TEST_P(RefineTest, KeepsAClosedSurfaceClosed) {
  SceneMesh mesh = Octahedron(GetParam());
  std::vector<int> tag = Numbers(mesh);
  RefineEdges(&mesh, &tag, 6, LongEdges(mesh));
  ASSERT_GT(mesh.triangles.size(), 200u);
  std::map<Edge, int> uses;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[EdgeOf(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]])];
    }
  }
  // Each edge is met once in each direction: a T-junction would leave one side alone.
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1);
    const Edge back = {edge[3], edge[4], edge[5], edge[0], edge[1], edge[2]};
    EXPECT_EQ(uses.count(back), 1u);
  }
}

TEST_P(RefineTest, KeepsEachFacesAreaDirectionMaterialAndTag) {
  const SceneMesh before = Octahedron(GetParam());
  SceneMesh mesh = before;
  std::vector<int> tag = Numbers(mesh);
  RefineEdges(&mesh, &tag, 6, LongEdges(mesh));
  mesh.materials.resize(before.triangles.size());
  mesh.Validate();
  ASSERT_EQ(tag.size(), mesh.triangles.size());
  std::vector<Vec> areas(before.triangles.size(), Vec::Zero());
  for (std::size_t t = 0; t < tag.size(); ++t) {
    const auto face = static_cast<std::size_t>(tag[t]);
    EXPECT_EQ(mesh.triangle_materials[t], before.triangle_materials[face]);
    const Vec area = AreaVector(mesh, t);
    const Vec normal = AreaVector(before, face).normalized();
    EXPECT_GT(area.dot(normal), 0.999f * area.norm());
    const Vec& corner = before.positions[before.triangles[face][0]];
    for (const std::uint32_t v : mesh.triangles[t]) {
      EXPECT_NEAR(normal.dot(mesh.positions[v] - corner), 0.0f, 1e-5f);
    }
    areas[face] += area;
  }
  for (std::size_t face = 0; face < areas.size(); ++face) {
    EXPECT_NEAR((areas[face] - AreaVector(before, face)).norm(), 0.0f, 1e-4f);
  }
}

TEST_P(RefineTest, PutsTextureAndColourInTheMiddleToo) {
  SceneMesh mesh = Octahedron(GetParam());
  std::vector<int> tag = Numbers(mesh);
  RefineEdges(&mesh, &tag, 6, LongEdges(mesh));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR((mesh.uvs[v] - mesh.positions[v].head<2>()).norm(), 0.0f, 1e-5f);
    EXPECT_NEAR(mesh.colors[v][0], 100.0f + 100.0f * mesh.positions[v].x(), 6.0f);
  }
}

TEST_P(RefineTest, GoesOnUntilNoEdgeIsToBeHalved) {
  SceneMesh mesh = Octahedron(GetParam());
  std::vector<int> tag = Numbers(mesh);
  const auto is_long = LongEdges(mesh);
  RefineEdges(&mesh, &tag, 20, is_long);
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_FALSE(is_long(t[k], t[(k + 1) % 3]));
  }
}

TEST_P(RefineTest, StopsAfterItsRounds) {
  for (const int rounds : {0, 1, 2, 3}) {
    SceneMesh mesh = Octahedron(GetParam());
    std::vector<int> tag = Numbers(mesh);
    RefineEdges(&mesh, &tag, rounds, [](auto, auto) {
      return true;
    });
    EXPECT_EQ(mesh.triangles.size(), 8u << (2 * rounds));
  }
}

TEST_P(RefineTest, LeavesAMeshAloneThatNeedsNothing) {
  const SceneMesh before = Octahedron(GetParam());
  SceneMesh mesh = before;
  std::vector<int> tag = Numbers(mesh);
  RefineEdges(&mesh, &tag, 5, [](auto, auto) {
    return false;
  });
  EXPECT_EQ(mesh.triangles, before.triangles);
  EXPECT_EQ(mesh.positions, before.positions);
  EXPECT_EQ(tag, Numbers(before));
}

INSTANTIATE_TEST_SUITE_P(Corners, RefineTest, testing::Bool(), [](const auto& test) {
  return test.param ? "Shared" : "OwnByFace";
});

TEST(Refine, TakesAnEmptyMesh) {
  SceneMesh mesh;
  std::vector<int> tag;
  RefineEdges(&mesh, &tag, 3, [](auto, auto) {
    return true;
  });
  EXPECT_TRUE(mesh.triangles.empty());
}

}  // namespace
}  // namespace bulletnav::sim
