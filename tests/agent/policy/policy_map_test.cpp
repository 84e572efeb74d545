// SPDX-License-Identifier: MIT
#include "agent/policy/policy_map.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::agent {
namespace {

enum Plane { kObstacle, kExplored, kBeen };

bool IsSet(const PolicyMap& map, int crop, Plane plane, int row, int col) {
  const int bit = ((crop * kMapPlanes + plane) * kMapSide + row) * kMapSide + col;
  return (map.bytes()[static_cast<std::size_t>(bit / 8)] >> bit % 8 & 1) != 0;
}

/// The room is x from -2 to 3 and y from -2 to 2 of a plane whose origin the body starts at.
class PolicyMapTest : public testing::Test {
 protected:
  /// Walks in the room as its odometry says.
  void See(const sim::PlanarPose& moved) {
    pose_ = sim::Compose(pose_, moved);
    const sim::BodyPose body = sim::Apply({{2, 0, -2}, 0.0}, pose_);
    const Eigen::Vector3d eye = body.position + Eigen::Vector3d(0, rig_.camera_height, 0);
    depth_ = tests::RenderPanorama(*scene_, rig_.panorama,
                                   {eye.cast<float>(), static_cast<float>(body.yaw)})
                 .depth;
    Observation observation;
    observation.panorama = {{}, depth_};
    observation.odometry = moved;
    map_.See(observation);
  }
  /// The point of the plane in the middle of a cell of a crop.
  Point PointAt(int crop, int row, int col) const {
    const double cell = crop == 0 ? 0.05 : 0.20;
    const double ahead = cell * (0.5 * (kMapSide - 1) - row);
    const double left = cell * (0.5 * (kMapSide - 1) - col);
    const sim::PlanarPose there = sim::Compose(pose_, {ahead, left, 0.0});
    return {there.x, there.y};
  }
  static double ToWall(const Point& p) {
    return std::min(
        {std::fabs(p.x + 2), std::fabs(p.x - 3), std::fabs(p.y + 2), std::fabs(p.y - 2)});
  }
  static bool IsInside(const Point& p) { return p.x > -2 && p.x < 3 && p.y > -2 && p.y < 2; }

  const Rig rig_;
  const std::unique_ptr<const sim::RenderScene> scene_ =
      sim::MakeRenderScene(tests::BoxRoom(4.0f, 2.6f, 5.0f), sim::Backend::kEmbree);
  PolicyMap map_{rig_};
  sim::PlanarPose pose_;
  std::vector<float> depth_;
};

TEST_F(PolicyMapTest, KnowsNothingAtFirstAndAfterAReset) {
  map_.Reset();
  for (int i = 0; i < 2; ++i) {
    for (const std::uint8_t byte : map_.bytes()) ASSERT_EQ(byte, 0);
    pose_ = {};
    See({0.0, 0.0, 0.3});
    map_.Reset();
  }
}

TEST_F(PolicyMapTest, ShowsTheRoomFromWhereTheBodyStandsAndAsItIsTurned) {
  map_.Reset();
  See({});
  See({0.5, 0.2, 0.7});
  See({-0.3, 0.4, 1.9});
  for (const int crop : {0, 1}) {
    const double cell = crop == 0 ? 0.05 : 0.20;
    const double slack = 0.75 * cell + 0.06;
    int walls = 0;
    for (int row = 0; row < kMapSide; ++row) {
      for (int col = 0; col < kMapSide; ++col) {
        const Point p = PointAt(crop, row, col);
        const bool is_wall = IsSet(map_, crop, kObstacle, row, col);
        walls += is_wall ? 1 : 0;
        EXPECT_TRUE(!is_wall || ToWall(p) < slack) << crop << " " << p.x << " " << p.y;
        if (ToWall(p) < slack) continue;
        const double away = std::hypot(p.x - pose_.x, p.y - pose_.y);
        const bool is_seen = IsSet(map_, crop, kExplored, row, col);
        EXPECT_TRUE(IsInside(p) || !is_seen) << crop << " " << p.x << " " << p.y;
        EXPECT_TRUE(!IsInside(p) || away > 3.0 || is_seen) << crop << " " << p.x << " " << p.y;
      }
    }
    EXPECT_GT(walls, crop == 0 ? 20 : 60);
  }
}

TEST_F(PolicyMapTest, RemembersItsWay) {
  map_.Reset();
  See({});
  for (int i = 0; i < 4; ++i) See({0.25, 0.0, 0.0});
  See({0.0, 0.0, -sim::kPi / 2});  // its way now lies to the right of it, and behind is no way
  constexpr int kMiddle = kMapSide / 2;
  for (const int crop : {0, 1}) {
    const int length = crop == 0 ? 20 : 5;  // cells of a metre
    EXPECT_TRUE(IsSet(map_, crop, kBeen, kMiddle, kMiddle));
    EXPECT_TRUE(IsSet(map_, crop, kBeen, kMiddle, kMiddle + length - 1)) << crop;
    EXPECT_FALSE(IsSet(map_, crop, kBeen, kMiddle, kMiddle - length / 2)) << crop;
    EXPECT_FALSE(IsSet(map_, crop, kBeen, kMiddle + length / 2, kMiddle)) << crop;
    EXPECT_FALSE(IsSet(map_, crop, kBeen, kMiddle - length / 2, kMiddle)) << crop;
  }
}

TEST(PolicyMap, NeedsDepthAndSoundOdometry) {
  Rig blind;
  blind.has_depth = false;
  EXPECT_THROW(PolicyMap{blind}, sim::Error);
  PolicyMap map{Rig{}};
  Observation observation;
  observation.odometry.x = std::nan("");
  EXPECT_THROW(map.See(observation), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
