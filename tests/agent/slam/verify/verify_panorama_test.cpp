// SPDX-License-Identifier: MIT
#include "agent/slam/verify/verify_panorama.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/math/rng.h"
#include "sim/render/projection.h"

namespace bulletnav::agent {
namespace {

const PanoramaLens kLens = PanoramaLens::Of(128, 512);

struct View {
  OrbFeatures features;
  std::vector<Eigen::Vector3d> points;
  PlacedCorners corners() const { return {&features, points}; }
};

/// A point of a body's surroundings as the panorama has it: at a whole pixel, its distance as it
/// is.
Eigen::Vector3d AsSeen(const Eigen::Vector3d& point) {
  PicturePoint place = kLens.PlaceOf(point);
  place.col = std::round(place.col);
  place.row = std::round(place.row);
  return kLens.PointAt(place);
}

Eigen::Vector3d SomePoint(sim::Rng* rng) {
  const double bearing = rng->Uniform(-sim::kPi, sim::kPi);
  const double far = rng->Uniform(1.0, 5.0);
  return {far * std::cos(bearing), far * std::sin(bearing), rng->Uniform(-0.9, 0.9)};
}

/// The same points from two places: of `wrong` of them the second sees another point.
std::pair<View, View> TwoViews(const sim::PlanarPose& X_AB, int points, int wrong) {
  sim::Rng rng(1, "points");
  std::pair<View, View> views;
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector3d in_a = SomePoint(&rng);
    const double dx = in_a.x() - X_AB.x;
    const double dy = in_a.y() - X_AB.y;
    const double c = std::cos(X_AB.yaw);
    const double s = std::sin(X_AB.yaw);
    const Eigen::Vector3d in_b(c * dx + s * dy, c * dy - s * dx, in_a.z());
    BinaryDescriptor descriptor{};
    for (std::uint64_t& word : descriptor) {
      word = (static_cast<std::uint64_t>(rng.Next()) << 32) | rng.Next();
    }
    for (View* view : {&views.first, &views.second}) {
      view->features.corners.emplace_back();
      view->features.descriptors.push_back(descriptor);
    }
    views.first.points.push_back(AsSeen(in_a));
    views.second.points.push_back(AsSeen(i < wrong ? SomePoint(&rng) : in_b));
  }
  return views;
}

TEST(PanoramaLens, SeesPointsWhereTheRendererDrawsThem) {
  const sim::RayGrid grid(sim::PanoramaSpec{});
  for (const int row : {0, 40, 127}) {
    for (const int col : {0, 1, 200, 256, 511}) {
      const Eigen::Vector3f ray =
          grid.Direction(static_cast<std::size_t>(row), static_cast<std::size_t>(col));
      // The camera looks along -z, x is on its right.
      const Eigen::Vector3d point(-2.0 * ray.z(), -2.0 * ray.x(), 2.0 * ray.y());
      EXPECT_LT((kLens.PointAt({double(col), double(row), 2.0}) - point).norm(), 1e-5);
      const PicturePoint place = kLens.PlaceOf(point);
      EXPECT_NEAR(place.col, col, 1e-3);
      EXPECT_NEAR(place.row, row, 1e-3);
      EXPECT_NEAR(place.level_m, 2.0, 1e-5);
      const PicturePoint coarse = kLens.Every(4, 2, 2).PlaceOf(point);
      EXPECT_NEAR(std::remainder(4.0 * coarse.col + 2.0 - col, 512.0), 0.0, 1e-3);
      EXPECT_NEAR(4.0 * coarse.row + 2.0, row, 1e-3);
    }
  }
}

TEST(VerifyPanorama, FindsTheMotionAmongWrongPairs) {
  for (const sim::PlanarPose& X_AB :
       {sim::PlanarPose{0.0, 0.0, 0.0}, sim::PlanarPose{0.8, -0.5, 2.5},
        sim::PlanarPose{-1.2, 0.3, -3.1}}) {
    const auto [a, b] = TwoViews(X_AB, 80, 40);
    const auto motion = FindMotion(a.corners(), b.corners(), kLens, {});
    ASSERT_TRUE(motion.has_value());
    EXPECT_EQ(motion->matches, 80);
    EXPECT_GE(motion->inliers, 36);
    EXPECT_LE(motion->inliers, 46);
    EXPECT_NEAR(motion->X_AB.x, X_AB.x, 0.02);
    EXPECT_NEAR(motion->X_AB.y, X_AB.y, 0.02);
    EXPECT_NEAR(sim::WrapAngle(motion->X_AB.yaw - X_AB.yaw), 0.0, 0.01);
    const auto again = FindMotion(a.corners(), b.corners(), kLens, {});
    EXPECT_EQ(again->X_AB.x, motion->X_AB.x);
    EXPECT_EQ(again->X_AB.yaw, motion->X_AB.yaw);
  }
}

TEST(VerifyPanorama, SaysNothingWhereTooFewAgree) {
  const auto [a, b] = TwoViews({0.5, 0.0, 1.0}, 40, 40);
  EXPECT_FALSE(FindMotion(a.corners(), b.corners(), kLens, {}).has_value());
  auto [c, d] = TwoViews({0.5, 0.0, 1.0}, 40, 0);
  EXPECT_TRUE(FindMotion(c.corners(), d.corners(), kLens, {}).has_value());
  VerifySpec near;
  near.distance_m = 0.4;
  EXPECT_FALSE(FindMotion(c.corners(), d.corners(), kLens, near).has_value());
  for (Eigen::Vector3d& point : c.points) point.setZero();  // without depth
  EXPECT_FALSE(FindMotion(c.corners(), d.corners(), kLens, {}).has_value());
}

TEST(VerifyPanorama, CornersAreWhereTheirPixelsSay) {
  OrbFeatures features;
  features.corners = {{255.6f, 63.5f, 31.0f, 0.0f}, {0.0f, 0.0f, 31.0f, 0.0f}};
  std::vector<float> level(128 * 512, 0.0f);
  level[64 * 512 + 256] = 3.0f;
  const auto points = PointsAt(level, 512, 128, kLens, features);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR((points[0] - Eigen::Vector3d(3.0, 0.0, 0.0)).norm(), 0.0, 0.02);
  EXPECT_TRUE(points[1].isZero());
}

}  // namespace
}  // namespace bulletnav::agent
