// SPDX-License-Identifier: MIT
#include "agent/slam/verify/projected_matches.h"

#include <gtest/gtest.h>

#include "sim/math/rng.h"
#include "tests/agent/slam/retrieval/random_descriptors.h"

namespace bulletnav::agent {
namespace {

constexpr Pinhole kCamera = {160.0, 160.0, 159.5, 119.5};

struct View {
  OrbFeatures features;
  std::vector<float> depths;
  DepthCorners corners() const { return {&features, depths}; }
};

struct Point {
  Eigen::Vector3d in_a;
  BinaryDescriptor descriptor;
};

std::vector<Point> Points(int count) {
  sim::Rng rng(4, "points");
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d at(rng.Uniform(-2, 2), rng.Uniform(-1, 1), rng.Uniform(3, 6));
    points.push_back({at, tests::RandomDescriptor(&rng)});
  }
  return points;
}

/// A body's pose as its camera's.
SpatialPose CameraOf(const sim::PlanarPose& body) {
  return {{-body.y, 0.0, body.x}, RotationBy({0.0, -body.yaw, 0.0})};
}

/// What a body at X_AB sees of the points.
View See(const std::vector<Point>& points, const sim::PlanarPose& X_AB) {
  const SpatialPose X_BA = Inverse(CameraOf(X_AB));
  View view;
  for (const Point& point : points) {
    const Eigen::Vector3d at = X_BA.rotation * point.in_a + X_BA.position;
    view.features.corners.push_back({static_cast<float>(kCamera.cx + kCamera.fx * at.x() / at.z()),
                                     static_cast<float>(kCamera.cy + kCamera.fy * at.y() / at.z()),
                                     31.0F, 0.0F});
    view.features.descriptors.push_back(point.descriptor);
    view.depths.push_back(static_cast<float>(at.z()));
  }
  return view;
}

TEST(ProjectedMatches, AllPointsOfAGroupAreFoundOnceWhereTheMotionIsRight) {
  const std::vector<Point> points = Points(80);
  const sim::PlanarPose X_AG = {0.3, -0.2, 0.2};
  const sim::PlanarPose X_AB = {0.5, 0.3, -0.3};
  const View a = See(points, {});
  const View g = See(points, X_AG);
  const View b = See(points, X_AB);
  const std::vector<GroupFrame> group = {{a.corners(), {}}, {g.corners(), X_AG}};
  EXPECT_EQ(CountProjected(group, b.features, CameraOf(X_AB), kCamera, {}), 80);
  EXPECT_EQ(CountProjected({&group[1], 1}, b.features, CameraOf(X_AB), kCamera, {}), 80);
}

TEST(ProjectedMatches, FewAreFoundWhereItIsWrong) {
  const std::vector<Point> points = Points(80);
  const View a = See(points, {});
  const View b = See(points, {0.5, 0.3, -0.3});
  const std::vector<GroupFrame> group = {{a.corners(), {}}};
  EXPECT_LT(CountProjected(group, b.features, CameraOf({0.5, 0.3, 0.3}), kCamera, {}), 5);
  // Where the motion is right, but all look different.
  View other = b;
  sim::Rng rng(5, "other");
  for (auto& descriptor : other.features.descriptors) descriptor = tests::RandomDescriptor(&rng);
  EXPECT_EQ(CountProjected(group, other.features, CameraOf({0.5, 0.3, -0.3}), kCamera, {}), 0);
}

TEST(ProjectedMatches, CornersWithoutDepthAreNoPoints) {
  const std::vector<Point> points = Points(10);
  View a = See(points, {});
  a.depths.assign(a.depths.size(), 0.0F);
  const std::vector<GroupFrame> group = {{a.corners(), {}}};
  EXPECT_EQ(CountProjected(group, a.features, {}, kCamera, {}), 0);
}

}  // namespace
}  // namespace bulletnav::agent
