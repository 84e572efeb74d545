// SPDX-License-Identifier: MIT
// Coarse copies of fine meshes, and pictures with them.
#include "sim/render/detail/levels_of_detail.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "sim/math/rng.h"
#include "sim/math/segment_triangle.h"
#include "sim/render/cpu/cpu_scene.h"
#include "sim/render/detail/coarse_patch.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using tests::Panorama;
using tests::RenderPanorama;
using Vec = Eigen::Vector3f;

using Height = float (*)(float, float);
using Color = Rgb8 (*)(float, float);

float Flat(float, float) {
  return 0.0f;
}
float Wavy(float x, float z) {
  return 0.02f * std::sin(3.0f * x) * std::cos(2.0f * z);
}
float Rough(float x, float z) {
  return 0.1f * std::sin(40.0f * x) * std::cos(40.0f * z);
}
Rgb8 White(float, float) {
  return kWhite;
}
/// Red or white without order, from vertex to vertex of a sheet with 20 of them to the metre.
Rgb8 Speckled(float x, float z) {
  const long i = std::lround(20.0f * x);
  const long j = std::lround(20.0f * z);
  return (i * i * j + i * j * j / 3 + i / 2) % 2 == 0 ? Rgb8{250, 40, 40} : kWhite;
}
/// Darker by steps of half a metre.
Rgb8 Stepped(float x, float) {
  return x < 0.5f ? kWhite : Rgb8{90, 80, 70};
}

/// A square of `side` metres in the x-z plane, cut into 2 n^2 triangles that share their vertices.
SceneMesh Sheet(float side, int n, Height height, Color color) {
  SceneMesh mesh;
  mesh.materials = {{"grey", {128, 128, 128}, -1}};
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const float x = side * static_cast<float>(i) / static_cast<float>(n);
      const float z = side * static_cast<float>(j) / static_cast<float>(n);
      mesh.positions.emplace_back(x, height(x, z), -z);
      mesh.uvs.emplace_back(x, z);
      mesh.colors.push_back(color(x, z));
    }
  }
  const auto at = [n](int i, int j) {
    return static_cast<std::uint32_t>(i * (n + 1) + j);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  mesh.triangle_materials.assign(mesh.triangles.size(), 0);
  return mesh;
}

std::vector<std::uint32_t> All(const SceneMesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

Triangle3d TriangleOf(const SceneMesh& mesh, const std::array<std::uint32_t, 3>& corners) {
  Triangle3d triangle;
  for (std::size_t k = 0; k < 3; ++k) triangle[k] = mesh.positions[corners[k]].cast<double>();
  return triangle;
}

double AreaOf(const SceneMesh& mesh, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  double area = 0.0;
  for (const auto& corners : triangles) {
    const auto [a, b, c] = TriangleOf(mesh, corners);
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

TEST(CoarsePatch, OfAFlatSheetIsTheSheet) {
  const SceneMesh mesh = Sheet(1, 20, Flat, White);
  const auto patch = Simplified(mesh, All(mesh), 0.01);
  ASSERT_TRUE(patch);
  EXPECT_LT(patch->triangles.size(),
            120u);  // no fewer
                    // than the
                    // 80 edges
                    // of its
                    // border
                    // allow
  EXPECT_LT(patch->error, 1e-6);
  EXPECT_NEAR(AreaOf(mesh, patch->triangles), 1.0, 1e-5);
}

TEST(CoarsePatch, IsAsWrongAsItSays) {
  const SceneMesh mesh = Sheet(2, 30, Wavy, White);
  const auto patch = Simplified(mesh, All(mesh), 0.01);
  ASSERT_TRUE(patch);
  EXPECT_LE(2 * patch->triangles.size(), mesh.triangles.size());
  EXPECT_LE(patch->error, 0.02);
  double worst = 0.0;
  for (const Vec& p : mesh.positions) {
    double nearest = 1e9;
    for (const auto& corners : patch->triangles) {
      nearest =
          std::min(nearest, PointToTriangle(p.cast<double>(), TriangleOf(mesh, corners)).distance);
    }
    worst = std::max(worst, nearest);
  }
  EXPECT_NEAR(worst, patch->error, 1e-9);
}

TEST(CoarsePatch, KeepsBordersColoursAndRoughness) {
  EXPECT_FALSE(Simplified(Sheet(1, 20, Rough, White), All(Sheet(1, 20, Rough, White)), 0.01));
  const SceneMesh speckled = Sheet(1, 20, Flat, Speckled);
  EXPECT_FALSE(Simplified(speckled, All(speckled), 0.01));
}

TEST(CoarsePatch, ColoursStayWhereTheyWere) {
  const SceneMesh mesh = Sheet(1, 20, Flat, Stepped);
  const auto patch = Simplified(mesh, All(mesh), 0.01);
  ASSERT_TRUE(patch);
  // Only triangles
  // between the last
  // white column and the
  // first dark one have
  // both colours.
  for (const auto& corners : patch->triangles) {
    float least = 1.0f;
    float most = 0.0f;
    for (const std::uint32_t v : corners) {
      least = std::min(least, mesh.positions[v].x());
      most = std::max(most, mesh.positions[v].x());
    }
    EXPECT_TRUE(most < 0.5f || least > 0.44f) << least << " to " << most;
  }
}

TEST(CoarsePatch, MaterialsStayApart) {
  SceneMesh mesh = Sheet(1, 20, Flat, White);
  mesh.materials.push_back({"red", {200, 0, 0}, -1});
  for (std::size_t t = 0; t < 400; ++t) mesh.triangle_materials[t] = 1;
  const auto patch = Simplified(mesh, All(mesh), 0.01);
  ASSERT_TRUE(patch);
  double red = 0.0;
  for (std::size_t i = 0; i < patch->triangles.size(); ++i) {
    if (mesh.triangle_materials[patch->like[i]] == 1) red += AreaOf(mesh, {patch->triangles[i]});
  }
  EXPECT_NEAR(red, 0.5, 1e-5);
}

/// A closed room with a
/// finely cut wavy floor.
SceneMesh FineRoom() {
  SceneMesh mesh = tests::BoxRoom(12, 3, 12);
  const SceneMesh floor = Sheet(
      12, 160,
      [](float x, float z) {
        return 0.3f + Wavy(x, z);
      },
      White);
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), floor.positions.begin(), floor.positions.end());
  mesh.uvs.insert(mesh.uvs.end(), floor.uvs.begin(), floor.uvs.end());
  mesh.colors.insert(mesh.colors.end(), floor.colors.begin(), floor.colors.end());
  for (auto corners : floor.triangles) {
    for (std::uint32_t& corner : corners) corner += base;
    mesh.triangles.push_back(corners);
    mesh.triangle_materials.push_back(0);
  }
  mesh.Validate();
  return mesh;
}

TEST(LevelsOfDetail, PicturesAgreeWithTheFullMesh) {
  SceneMesh mesh = FineRoom();
  const auto full = MakeCpuScene(mesh);
  mesh.levels_of_detail = true;
  const auto coarse = MakeCpuScene(mesh);
  PinholeSpec down;
  down.pitch_deg = -20;
  Rng rng(1, "cameras");
  for (const CameraSpec& spec : {CameraSpec(PanoramaSpec{}), CameraSpec(down)}) {
    tests::Agreement agreement;
    for (int i = 0; i < 4; ++i) {
      const CameraPose camera = {
          {static_cast<float>(rng.Uniform(1, 11)), 1.4f, static_cast<float>(-rng.Uniform(1, 11))},
          static_cast<float>(rng.Uniform(-3, 3))};
      agreement.Add(RenderPanorama(*full, spec, camera), RenderPanorama(*coarse, spec, camera));
    }
    EXPECT_GE(agreement.depth(), 0.995);
    EXPECT_GE(agreement.color(), 0.99);
  }
}

TEST(LevelsOfDetail, AreFewerTrianglesInBothLevels) {
  const SceneMesh scene = FineRoom();
  RenderMesh mesh(scene);
  Bvh bvh(mesh.corners);
  AddLevelsOfDetail(scene, &mesh, &bvh);
  EXPECT_EQ(mesh.corners.size(), mesh.shading.size());
  EXPECT_LT(mesh.corners.size(), 2 * scene.triangles.size());
  int details = 0;
  for (const BvhNode& node : bvh.nodes) {
    if (node.count != kDetailNode) continue;
    ++details;
    EXPECT_GE(node.low[0][0], 0.0f);
    EXPECT_LE(node.low[0][0], 0.06f);
  }
  EXPECT_GT(details, 50);
}

TEST(LevelsOfDetail, KernelsDrawTheSameBits) {
  SceneMesh mesh = FineRoom();
  mesh.levels_of_detail = true;
  const CameraPose camera{{3, 1.5f, -4}, 1.0f};
  const Panorama best = RenderPanorama(*MakeCpuScene(mesh), PanoramaSpec{}, camera);
  for (const Kernels* kernels : SupportedKernels()) {
    const Panorama other = RenderPanorama(*MakeCpuScene(mesh, *kernels), PanoramaSpec{}, camera);
    EXPECT_EQ(other.color, best.color) << kernels->name;
    EXPECT_EQ(other.depth, best.depth) << kernels->name;
  }
}

}  // namespace
}  // namespace
   // bulletnav::sim
