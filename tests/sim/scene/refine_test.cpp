// SPDX-License-Identifier: MIT
#include "sim/scene/refine.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "sim/scene/mesh_measures.h"
#include "sim/scene/patches.h"
#include "sim/scene/smooth_noise.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

TEST(Refine, KeepsAreaAndMaterialsAndShortensEdges) {
  SceneMesh mesh = tests::BoxRoom(5, 2.5f, 3);
  const double area = AreaOf(mesh);
  RefineTo(0.3, &mesh);
  mesh.Validate();
  EXPECT_NEAR(AreaOf(mesh), area, 1e-3 * area);
  for (const auto& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LE((mesh.positions[corners[i]] - mesh.positions[corners[(i + 1) % 3]]).norm(), 0.301f);
    }
  }
}

/// An edge inside of a surface belongs to two triangles; if one of them had been cut and not the
/// other, there would be a crack once vertices move.
TEST(Refine, LeavesNoCracks) {
  SceneMesh mesh = tests::BoxRoom(5, 2.5f, 3);
  // Longer edges on one side than on the other.
  Refine(
      [](std::uint32_t, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
        const float limit = 0.1f + 0.2f * std::max(0.0f, 0.5f * (a.x() + b.x()));
        return (a - b).norm() > limit;
      },
      &mesh);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = corners[i];
      const auto b = corners[(i + 1) % 3];
      ++uses[{std::min(a, b), std::max(a, b)}];
    }
  }
  const Eigen::AlignedBox3f box = mesh.Bounds();
  for (const auto& [edge, count] : uses) {
    if (count == 2) continue;
    const Eigen::Vector3f middle =
        0.5f * (mesh.positions[edge.first] + mesh.positions[edge.second]);
    int sides = 0;  // of the room that it lies on: edges of its faces lie on two
    for (int i = 0; i < 3; ++i) {
      sides += std::abs(middle[i] - box.min()[i]) < 1e-4f ? 1 : 0;
      sides += std::abs(middle[i] - box.max()[i]) < 1e-4f ? 1 : 0;
    }
    EXPECT_GE(sides, 2) << middle.transpose();
  }
}

TEST(SmoothNoise, IsContinuousAndFillsItsRange) {
  const SmoothNoise noise(7, 0.5);
  float least = 1;
  float most = -1;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3f p(0.011f * static_cast<float>(i), 1.3f, -0.007f * static_cast<float>(i));
    const float here = noise.At(p);
    least = std::min(least, here);
    most = std::max(most, here);
    EXPECT_LT(std::abs(noise.At(p + Eigen::Vector3f::Constant(1e-3f)) - here), 0.03f);
  }
  EXPECT_GE(least, -1.0f);
  EXPECT_LE(most, 1.0f);
  EXPECT_LT(least, -0.5f);
  EXPECT_GT(most, 0.5f);
  EXPECT_NE(SmoothNoise(8, 0.5).At({0.3f, 0.2f, 0.1f}), noise.At({0.3f, 0.2f, 0.1f}));
}

TEST(Patches, HaveTheShareThatWasAskedFor) {
  const std::vector<float> values = {5, 1, 4, 2, 3};
  const std::vector<double> weights = {1, 1, 1, 1, 1};
  const auto above = [&](double share) {
    const float threshold = ThresholdOf(values, weights, share);
    return std::count_if(values.begin(), values.end(), [&](float v) {
      return v > threshold;
    });
  };
  EXPECT_EQ(above(0.0), 0);
  EXPECT_EQ(above(0.4), 2);
  EXPECT_EQ(above(0.6), 3);
  EXPECT_EQ(above(1.0), 5);
}

}  // namespace
}  // namespace bulletnav::sim
