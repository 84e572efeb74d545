// SPDX-License-Identifier: MIT
#include "sim/house/light_sources.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/math/pose.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

constexpr int kSky = static_cast<int>(Glow::kSky);
constexpr int kLamp = static_cast<int>(Glow::kLamp);
constexpr int kNone = static_cast<int>(Glow::kNone);

/// Triangles that glow and others, and the rays' view of them.
class Stage {
 public:
  /// Upright rectangle in the plane z = 0, centred on (0, 1, 0), that faces +z.
  void AddWindow(float width, float height) {
    const float x = 0.5f * width;
    const float y = 0.5f * height;
    tests::AddQuad({-x, 1 - y, 0}, {x, 1 - y, 0}, {x, 1 + y, 0}, {-x, 1 + y, 0}, kWhite, &mesh_);
    glows_.resize(mesh_.triangles.size(), kSky);
  }
  void AddLamp(const Vec& centre, float size) {
    const Vec half = Vec::Constant(0.5f * size);
    tests::AddBox(centre - half, centre + half, kWhite, &mesh_);
    glows_.resize(mesh_.triangles.size(), kLamp);
  }
  void AddObstacle(const Vec& low, const Vec& high) {
    tests::AddBox(low, high, kWhite, &mesh_);
    glows_.resize(mesh_.triangles.size(), kNone);
  }

  float Light(const Vec& point, const Vec& normal) const {
    std::vector<std::array<Vec, 3>> corners;
    for (const auto& [a, b, c] : mesh_.triangles) {
      corners.push_back({mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]});
    }
    const RayTracer scene(corners);
    const Vec light = LightSources(mesh_, glows_).Irradiance(scene, point, normal);
    EXPECT_TRUE(light.allFinite());
    EXPECT_GE(light.minCoeff(), 0.0f);
    return light.mean();
  }

 private:
  SceneMesh mesh_;
  std::vector<int> glows_;
};

Stage OneWindow(float width, float height) {
  Stage stage;
  stage.AddWindow(width, height);
  return stage;
}

Stage OneLamp(const Vec& centre, float size) {
  Stage stage;
  stage.AddLamp(centre, size);
  return stage;
}

/// The part of all light that a point gets from a window as in Stage, summed finely.
double FormFactor(double width, double height, const Vec& point, const Vec& normal) {
  constexpr int kCells = 60;
  double sum = 0.0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const Eigen::Vector3d on_window(width * ((i + 0.5) / kCells - 0.5),
                                      1.0 + height * ((j + 0.5) / kCells - 0.5), 0.0);
      const Eigen::Vector3d way = on_window - point.cast<double>();
      const double facing = -way.z();
      const double cosine = normal.cast<double>().dot(way);
      if (facing <= 0.0 || cosine <= 0.0) continue;
      sum += facing * cosine / (kPi * std::pow(way.squaredNorm(), 2));
    }
  }
  return sum * width * height / (kCells * kCells);
}

TEST(LightSources, LightOfAWindowFollowsItsFormFactor) {
  const Stage stage = OneWindow(1.6f, 1.2f);
  const Vec ahead(0.0f, 1.0f, 3.0f);
  const double scale =
      stage.Light(ahead, -Vec::UnitZ()) / FormFactor(1.6, 1.2, ahead, -Vec::UnitZ());
  for (const Vec& point : {Vec(0, 1, 2), Vec(1, 1, 3), Vec(-2, 0, 3), Vec(0, 0, 5), Vec(2, 2, 6)}) {
    for (const Vec& normal : {Vec(0, 0, -1), Vec(0, 1, 0), Vec(0.6f, 0, -0.8f)}) {
      const double expected = scale * FormFactor(1.6, 1.2, point, normal);
      EXPECT_NEAR(stage.Light(point, normal), expected, 0.08 * expected + 0.002)
          << point.transpose() << " facing " << normal.transpose();
    }
  }
}

TEST(LightSources, LightOfAWindowGrowsWithItsArea) {
  const Vec point(0.0f, 1.0f, 6.0f);
  const float small = OneWindow(0.5f, 0.5f).Light(point, -Vec::UnitZ());
  EXPECT_NEAR(OneWindow(1.0f, 1.0f).Light(point, -Vec::UnitZ()), 4.0f * small, 0.1f * small);
}

TEST(LightSources, AWindowShinesOnOneSideOnly) {
  const Stage stage = OneWindow(1.0f, 1.0f);
  EXPECT_GT(stage.Light({0, 1, 2}, -Vec::UnitZ()), 0.01f);
  EXPECT_EQ(stage.Light({0, 1, -2}, Vec::UnitZ()), 0.0f);
  EXPECT_EQ(stage.Light({0, 1, 2}, Vec::UnitZ()), 0.0f);  // turned away
}

TEST(LightSources, AnObstacleCastsAShadow) {
  Stage stage = OneWindow(1.0f, 1.0f);
  const float free = stage.Light({0, 1, 3}, -Vec::UnitZ());
  stage.AddObstacle({-2, -2, 1}, {2, 0.99f, 1.1f});  // the lower half
  const float half = stage.Light({0, 1, 3}, -Vec::UnitZ());
  EXPECT_NEAR(half, 0.5f * free, 0.2f * free);
  stage.AddObstacle({-2, -2, 1.2f}, {2, 4, 1.3f});
  EXPECT_EQ(stage.Light({0, 1, 3}, -Vec::UnitZ()), 0.0f);
}

TEST(LightSources, LightFromFarAwayIsLeftOut) {
  const Stage stage = OneWindow(1.0f, 1.0f);
  EXPECT_GT(stage.Light({0, 1, 8.5f}, -Vec::UnitZ()), 0.0f);
  EXPECT_EQ(stage.Light({0, 1, 10}, -Vec::UnitZ()), 0.0f);
}

TEST(LightSources, ALampShinesAllAround) {
  const Stage stage = OneLamp({0, 2, 0}, 0.2f);
  const float below = stage.Light({0, 0, 0}, Vec::UnitY());
  EXPECT_GT(below, 0.01f);
  EXPECT_NEAR(stage.Light({2, 2, 0}, -Vec::UnitX()), below, 1e-3f * below);
  EXPECT_NEAR(stage.Light({0, 2, -2}, Vec::UnitZ()), below, 1e-3f * below);
}

TEST(LightSources, ALampGivesNoLightToItsOwnCentre) {
  const Stage stage = OneLamp({0, 2, 0}, 0.25f);  // the centre is exact
  EXPECT_EQ(stage.Light({0, 2, 0}, Vec::UnitY()), 0.0f);
  EXPECT_EQ(stage.Light({0, 2, 0}, Vec::Zero()), 0.0f);
}

TEST(LightSources, ALampGivesTheSameWhateverItsSizeAndParts) {
  const Vec point(0.0f, 0.0f, 1.0f);
  const float light = OneLamp({0, 2, 0}, 0.1f).Light(point, Vec::UnitY());
  EXPECT_NEAR(OneLamp({0, 2, 0}, 0.2f).Light(point, Vec::UnitY()), light, 1e-3f * light);
  Stage parts = OneLamp({-0.1f, 2, 0}, 0.1f);
  parts.AddLamp({0.1f, 2, 0}, 0.1f);
  EXPECT_NEAR(parts.Light(point, Vec::UnitY()), light, 1e-3f * light);
}

TEST(LightSources, LampsApartAddUp) {
  const Vec middle(0.0f, 0.0f, 0.0f);
  const float one = OneLamp({1.5f, 2, 0}, 0.1f).Light(middle, Vec::UnitY());
  Stage two = OneLamp({1.5f, 2, 0}, 0.1f);
  two.AddLamp({-1.5f, 2, 0}, 0.1f);
  EXPECT_NEAR(two.Light(middle, Vec::UnitY()), 2.0f * one, 1e-3f * one);
}

TEST(LightSources, StaysFiniteAtASource) {
  EXPECT_LT(OneWindow(1.0f, 1.0f).Light({0, 1, 0.001f}, -Vec::UnitZ()), 100.0f);
  EXPECT_LT(OneLamp({0, 2, 0}, 0.2f).Light({0, 1.99f, 0}, Vec::UnitY()), 100.0f);
}

TEST(LightSources, WithoutSourcesItIsDark) {
  Stage stage;
  stage.AddObstacle({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(stage.Light({2, 2, 2}, Vec::UnitY()), 0.0f);
}

}  // namespace
}  // namespace bulletnav::sim
