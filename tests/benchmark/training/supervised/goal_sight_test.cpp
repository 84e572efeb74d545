// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/goal_sight.h"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/support/scenes.h"
#include "tests/support/training_scenes.h"

namespace bulletnav::bench {
namespace {

using testing::DoubleNear;
using tests::StandingAt;

/// Whether one place of a scene is of the node of another, for all that a test tells apart.
bool SameNode(const sim::SceneMesh& mesh, const sim::BodyPose& source, const sim::BodyPose& goal,
              const DataConfig& config = {}) {
  const GoalSight sight(config.panorama);
  return sight.IsSameNode(tests::DepthFrom(mesh, config, source), RelativePose(source, goal),
                          goal.position.y() - source.position.y());
}

TEST(GoalSightTest, RangeToTheWallsOfABoxIsKnown) {
  DataConfig config;
  const auto mesh = tests::BoxRoom(6, 2.5f, 4);
  for (const double yaw_deg : {0.0, 37.0, 180.0}) {
    const auto depth = tests::DepthFrom(mesh, config, StandingAt(2, -1, yaw_deg));
    const GoalSight sight(config.panorama);
    const double yaw = sim::DegToRad(yaw_deg);
    // Towards a wall the patch reaches 2.5 degrees to both sides.
    const double widest = 1.0 / std::cos(sim::DegToRad(2.5));
    EXPECT_THAT(sight.FarthestRange(depth, -yaw, 0.0), DoubleNear(3.0 * widest, 0.01));
    EXPECT_THAT(sight.FarthestRange(depth, sim::kPi / 2 - yaw, 0.0),
                DoubleNear(2.0 * widest, 0.01));
    EXPECT_THAT(sight.FarthestRange(depth, sim::kPi - yaw, 0.0), DoubleNear(1.0 * widest, 0.01));
    EXPECT_THAT(sight.FarthestRange(depth, -sim::kPi / 2 - yaw, 0.0),
                DoubleNear(4.0 * widest, 0.01));
  }
}

TEST(GoalSightTest, InOneRoomOnlyTheDistanceCounts) {
  const auto mesh = tests::BoxRoom(8, 2.5f, 8);
  const auto source = StandingAt(4, -4, 20);
  for (int k = 0; k < 24; ++k) {
    const double a = k * sim::kPi / 12.0;
    const auto at = [&](double d) {
      return StandingAt(4 + d * std::cos(a), -4 + d * std::sin(a), 5.0 * k);
    };
    EXPECT_TRUE(SameNode(mesh, source, at(0.2))) << k;
    EXPECT_TRUE(SameNode(mesh, source, at(2.99))) << k;
    EXPECT_FALSE(SameNode(mesh, source, at(3.01))) << k;
  }
  EXPECT_TRUE(SameNode(mesh, source, source));
}

TEST(GoalSightTest, AWallHidesNearPlacesAndADoorwayShowsThem) {
  const auto mesh = tests::TwoRooms();
  for (const double yaw_deg : {0.0, 90.0, -90.0, 123.0}) {
    EXPECT_FALSE(SameNode(mesh, StandingAt(3, -3.5, yaw_deg), StandingAt(5, -3.5)));
    EXPECT_FALSE(SameNode(mesh, StandingAt(3.7, -0.5, yaw_deg), StandingAt(4.3, -0.5)));
    EXPECT_TRUE(SameNode(mesh, StandingAt(3, -2, yaw_deg), StandingAt(5, -2)));
    EXPECT_TRUE(SameNode(mesh, StandingAt(5.4, -2.2, yaw_deg), StandingAt(2.6, -1.8)));
  }
}

TEST(GoalSightTest, SeesGoalsBehindAcrossTheSeamOfThePanorama) {
  const auto mesh = tests::TwoRooms();
  // The source looks away from the doorway: its middle lies on the seam.
  for (const double yaw_deg : {89.0, 90.0, 91.0}) {
    EXPECT_TRUE(SameNode(mesh, StandingAt(3, -2, yaw_deg), StandingAt(5, -2)));
    EXPECT_FALSE(SameNode(mesh, StandingAt(3, -3.5, yaw_deg), StandingAt(5, -3.5)));
  }
}

TEST(GoalSightTest, TheFarthestPointOfThePatchDecides) {
  const auto mesh = tests::TwoRooms();
  const auto source = StandingAt(2, -2, -90);  // looks at the doorway
  // From here the opening ends 12.3 degrees to the side, at the far edge of the jamb.
  const auto at = [&](double bearing_deg) {
    const double bearing = sim::DegToRad(bearing_deg);
    return Apply(source, {2.9 * std::cos(bearing), 2.9 * std::sin(bearing), 0.0});
  };
  EXPECT_TRUE(SameNode(mesh, source, at(11.0)));
  EXPECT_TRUE(SameNode(mesh, source, at(13.7)));
  EXPECT_FALSE(SameNode(mesh, source, at(16.0)));
}

TEST(GoalSightTest, OtherProjectionsAndCoarsePicturesSayTheSame) {
  const auto mesh = tests::TwoRooms();
  for (const sim::PanoramaSpec& spec :
       {sim::PanoramaSpec{.projection = sim::Projection::kEquirectangular},
        sim::PanoramaSpec{.projection = sim::Projection::kCubeStrip},
        sim::PanoramaSpec{.rows = 16, .cols = 64}}) {
    DataConfig config;
    config.panorama = spec;
    EXPECT_TRUE(SameNode(mesh, StandingAt(3, -2, 77), StandingAt(5, -2), config));
    EXPECT_FALSE(SameNode(mesh, StandingAt(3, -3.5, 77), StandingAt(5, -3.5), config));
  }
}

TEST(GoalSightTest, PixelsWithoutReturnTellNothing) {
  const DataConfig config;
  const std::vector<float> nothing(config.panorama.pixels(), 0.0f);
  EXPECT_FALSE(GoalSight(config.panorama).IsSameNode(nothing, {1.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace bulletnav::bench
