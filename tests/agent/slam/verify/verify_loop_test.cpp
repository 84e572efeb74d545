// SPDX-License-Identifier: MIT
#include "agent/slam/verify/verify_loop.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

constexpr Pinhole kCamera = {160.0, 160.0, 159.5, 119.5};

struct View {
  OrbFeatures features;
  std::vector<float> depths;
  DepthCorners corners() const { return {&features, depths}; }
};

BinaryDescriptor RandomDescriptor(sim::Rng* rng) {
  BinaryDescriptor descriptor{};
  for (std::uint64_t& word : descriptor) {
    word = (static_cast<std::uint64_t>(rng->Next()) << 32) | rng->Next();
  }
  return descriptor;
}

void Add(const Eigen::Vector3d& point, const BinaryDescriptor& descriptor, View* view) {
  view->features.corners.push_back(
      {static_cast<float>(kCamera.cx + kCamera.fx * point.x() / point.z()),
       static_cast<float>(kCamera.cy + kCamera.fy * point.y() / point.z()), 31.0f, 0.0f});
  view->features.descriptors.push_back(descriptor);
  view->depths.push_back(static_cast<float>(point.z()));
}

/// The same points from two cameras: of `wrong` of them the second sees another place.
std::pair<View, View> TwoViews(const SpatialPose& X_AB, int points, int wrong) {
  sim::Rng rng(1, "points");
  const SpatialPose X_BA = Inverse(X_AB);
  std::pair<View, View> views;
  while (static_cast<int>(views.first.depths.size()) < points) {
    const Eigen::Vector3d in_a(rng.Uniform(-3, 3), rng.Uniform(-1, 1), rng.Uniform(2, 6));
    Eigen::Vector3d in_b = X_BA.rotation * in_a + X_BA.position;
    if (in_b.z() < 0.5) continue;
    if (static_cast<int>(views.first.depths.size()) < wrong) {
      in_b = {rng.Uniform(-3, 3), rng.Uniform(-1, 1), rng.Uniform(2, 6)};
    }
    const BinaryDescriptor descriptor = RandomDescriptor(&rng);
    Add(in_a, descriptor, &views.first);
    Add(in_b, descriptor, &views.second);
  }
  return views;
}

/// A body's motion in the plane as its camera's.
SpatialPose CameraMotionOf(const sim::PlanarPose& motion) {
  return {{-motion.y, 0.0, motion.x}, RotationBy({0.0, -motion.yaw, 0.0})};
}

TEST(VerifyLoop, FindsTheMotionAmongWrongMatches) {
  const sim::PlanarPose moved = {0.6, -0.4, 0.5};
  const auto [a, b] = TwoViews(CameraMotionOf(moved), 100, 45);
  const auto found = FindMotion(a.corners(), b.corners(), kCamera, {});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->matches, 100);
  EXPECT_GE(found->inliers, 55);
  EXPECT_LE(found->inliers, 60);
  const auto level = LevelMotion(found->X_AB, {});
  ASSERT_TRUE(level.has_value());
  EXPECT_NEAR(level->x, moved.x, 0.01);
  EXPECT_NEAR(level->y, moved.y, 0.01);
  EXPECT_NEAR(level->yaw, moved.yaw, 0.005);
}

TEST(VerifyLoop, FindsNothingAmongWrongMatchesAlone) {
  const auto [a, b] = TwoViews({}, 60, 60);
  EXPECT_FALSE(FindMotion(a.corners(), b.corners(), kCamera, {}).has_value());
}

TEST(VerifyLoop, CornersWithoutDepthDoNotCount) {
  auto [a, b] = TwoViews({}, 30, 0);
  for (std::size_t i = 11; i < a.depths.size(); ++i) a.depths[i] = 0.0f;
  EXPECT_FALSE(FindMotion(a.corners(), b.corners(), kCamera, {}).has_value());
  a.depths[11] = 3.0f;
  VerifySpec spec;
  spec.inliers = 11;
  EXPECT_TRUE(FindMotion(a.corners(), b.corners(), kCamera, spec).has_value());
}

TEST(VerifyLoop, ALevelCameraNeitherTiltsNorRises) {
  EXPECT_TRUE(LevelMotion({{0.1, 0.2, 0.3}, RotationBy({0.0, 1.0, 0.0})}, {}).has_value());
  EXPECT_FALSE(LevelMotion({{0.1, 0.4, 0.3}, RotationBy({0.0, 1.0, 0.0})}, {}).has_value());
  EXPECT_FALSE(LevelMotion({{0.1, 0.0, 0.3}, RotationBy({0.2, 0.0, 0.0})}, {}).has_value());
  EXPECT_FALSE(LevelMotion({{0.1, 0.0, 0.3}, RotationBy({0.0, 0.0, 0.2})}, {}).has_value());
  EXPECT_FALSE(LevelMotion({{0.0, 0.0, 30.0}, RotationBy({0.0, 0.0, 0.0})}, {}).has_value());
}

/// What looks like two places is no match, nor what looks like nothing.
TEST(VerifyLoop, MatchesAreMutualAndClear) {
  sim::Rng rng(2, "descriptors");
  OrbFeatures a;
  OrbFeatures b;
  for (int i = 0; i < 4; ++i) a.descriptors.push_back(RandomDescriptor(&rng));
  b.descriptors = {a.descriptors[2], a.descriptors[0], a.descriptors[1], a.descriptors[1]};
  const std::vector<std::pair<int, int>> expected = {{0, 1}, {2, 0}};
  EXPECT_EQ(MutualMatches(a, b, {}), expected);
  EXPECT_TRUE(MutualMatches(a, {}, {}).empty());
}

TEST(VerifyLoop, ASpecThatMakesNoSenseIsRefused) {
  VerifySpec spec;
  spec.inliers = 3;
  EXPECT_THROW(spec.Validate(), sim::Error);
  spec = {};
  spec.ratio = 1.5;
  EXPECT_THROW(spec.Validate(), sim::Error);
  spec = {};
  spec.pixels = 0.0;
  EXPECT_THROW(spec.Validate(), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
