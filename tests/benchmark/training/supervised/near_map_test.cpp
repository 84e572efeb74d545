// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/near_map.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "benchmark/training/supervised/labels.h"
#include "tests/support/scenes.h"
#include "tests/support/training_scenes.h"

namespace bulletnav::bench {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using tests::StandingAt;

constexpr double kCellAndHalf = 0.08;

NearMap MapOf(const sim::SceneMesh& mesh, const sim::BodyPose& pose,
              const DataConfig& config = {}) {
  NearMap map(config);
  map.Project(tests::DepthFrom(mesh, config, pose));
  return map;
}

std::set<int> Explorable(const NearMap& map) {
  std::set<int> directions;
  for (int i = 0; i < agent::kDirections; ++i) {
    if (map.IsExplorable(i)) directions.insert(i);
  }
  return directions;
}

TEST(NearMapTest, InALargeRoomEveryDirectionIsExplorable) {
  const auto mesh = tests::BoxRoom(10, 2.5f, 10);
  for (const double yaw_deg : {0.0, 10.0, 133.0}) {
    const NearMap map = MapOf(mesh, StandingAt(5, -5, yaw_deg));
    for (int i = 0; i < agent::kDirections; ++i) {
      EXPECT_THAT(map.WayTo(i), DoubleNear(3.0, 0.02)) << i;
      EXPECT_EQ(map.Reach(i), 3.0) << i;
    }
  }
}

TEST(NearMapTest, InASmallRoomNoneIs) {
  const NearMap map = MapOf(tests::BoxRoom(4, 2.5f, 4), StandingAt(2, -2, 30));
  EXPECT_THAT(Explorable(map), IsEmpty());
}

TEST(NearMapTest, InAHallTheTwoEndsAreAndReachStopsABodyBeforeTheWalls) {
  const auto mesh = tests::BoxRoom(10, 2.5f, 4);
  const NearMap across = MapOf(mesh, StandingAt(5, -2, 0));
  EXPECT_THAT(Explorable(across), ElementsAre(2, 3, 4, 8, 9, 10));
  EXPECT_THAT(across.Reach(0), DoubleNear(1.9, kCellAndHalf));
  EXPECT_THAT(across.Reach(1), DoubleNear(1.9 / std::cos(BearingOf(1)), kCellAndHalf));
  EXPECT_THAT(across.Reach(6), DoubleNear(1.9, kCellAndHalf));
  const NearMap along = MapOf(mesh, StandingAt(5, -2, 90));
  EXPECT_THAT(Explorable(along), ElementsAre(0, 1, 5, 6, 7, 11));
  EXPECT_THAT(along.Reach(3), DoubleNear(1.9, kCellAndHalf));
}

TEST(NearMapTest, WallsBeyondThreeMetresAreIgnored) {
  const NearMap map = MapOf(tests::BoxRoom(6.2f, 2.5f, 8), StandingAt(3.1, -4, 90));
  EXPECT_TRUE(map.IsExplorable(0));
  EXPECT_EQ(map.Reach(0), 3.0);
  EXPECT_FALSE(MapOf(tests::BoxRoom(5.9f, 2.5f, 8), StandingAt(2.95, -4, 90)).IsExplorable(0));
}

TEST(NearMapTest, ADoorwayIsExplorableAndTheWallBesideItIsNot) {
  const auto mesh = tests::TwoRooms();
  // Behind a source at the first room's middle the wall is nearer than 3 m on all sides.
  for (const int turn : {0, 1, 5, 6, 9}) {
    const NearMap map = MapOf(mesh, StandingAt(2, -2, -90 - 30.0 * turn));
    EXPECT_THAT(Explorable(map), ElementsAre(turn)) << turn;
  }
}

TEST(NearMapTest, AClosedDoorIsNot) {
  sim::SceneMesh mesh = tests::TwoRooms();
  tests::AddBox({3.98f, 0, -2.45f}, {4.02f, 2.05f, -1.55f}, {90, 60, 30}, &mesh);
  EXPECT_THAT(Explorable(MapOf(mesh, StandingAt(2, -2, -90))), IsEmpty());
}

TEST(NearMapTest, CorridorsAreExplorableAlongAndRoundTheCorner) {
  const auto mesh = tests::LCorridor(8, 8, 1.2f, 2.5f);
  EXPECT_THAT(Explorable(MapOf(mesh, StandingAt(2, -0.6, -90))), ElementsAre(0));
  EXPECT_THAT(Explorable(MapOf(mesh, StandingAt(4, -0.6, -90))), ElementsAre(0, 6));
  EXPECT_THAT(Explorable(MapOf(mesh, StandingAt(7.4, -0.6, 0))), ElementsAre(0, 3));
}

TEST(NearMapTest, WaysRoundABoxHaveTheirLength) {
  for (const double shift : {0.0, 0.05, 0.1, 0.15}) {
    sim::SceneMesh mesh = tests::BoxRoom(10, 2.5f, 10);
    const auto middle = static_cast<float>(5.0 + shift);
    tests::AddBox({middle - 0.2f, 0, -6.6f}, {middle + 0.2f, 1.0f, -6.5f}, {90, 60, 30}, &mesh);
    const NearMap map = MapOf(mesh, StandingAt(5, -5));
    const double aside = 0.3 - shift;  // of the nearer edge, a body away
    const double exact = std::hypot(1.4, aside) + 0.3 + std::hypot(1.3, aside);
    EXPECT_THAT(map.WayTo(0), DoubleNear(exact, 0.03 * exact)) << shift;
    EXPECT_TRUE(map.IsExplorable(0));
  }
}

TEST(NearMapTest, HiddenFloorCanBeWalkedOnOnlyIfTheConfigSaysSo) {
  // The point 3 m ahead lies behind the right jamb of the doorway, 1 cm farther than it would be in
  // the open.
  const sim::BodyPose source = StandingAt(3.2, -2.2, -128);
  const auto map_with = [&](HiddenFloor hidden) {
    DataConfig config;
    config.hidden = hidden;
    return MapOf(tests::TwoRooms(), source, config);
  };
  const NearMap free = map_with(HiddenFloor::kFree);
  const NearMap blocked = map_with(HiddenFloor::kBlocked);
  EXPECT_THAT(free.WayTo(0), DoubleNear(3.03, 0.05));
  EXPECT_FALSE(std::isfinite(blocked.WayTo(0)));
  EXPECT_THAT(free.Reach(0), DoubleNear(1.1, 0.3));  // to the jamb
  EXPECT_EQ(free.Reach(0), blocked.Reach(0));
}

TEST(NearMapTest, AWallHiddenBehindAWardrobeIsNotExplorable) {
  sim::SceneMesh mesh = tests::BoxRoom(4, 2.5f, 4);
  tests::AddBox({1.75f, 0, -3.1f}, {2.25f, 2.2f, -3}, {90, 60, 30}, &mesh);
  // Round the wardrobe and through the part of the wall that it hides the way would be 3.09 m.
  EXPECT_THAT(Explorable(MapOf(mesh, StandingAt(2, -2))), IsEmpty());
}

TEST(NearMapTest, LowThingsAreWalkedOverAndTablesAreNot) {
  sim::SceneMesh low = tests::BoxRoom(10, 2.5f, 10);
  tests::AddBox({4, 0, -7.5f}, {6, 0.2f, -7}, {90, 60, 30}, &low);
  EXPECT_TRUE(MapOf(low, StandingAt(5, -5)).IsExplorable(0));
  sim::SceneMesh table = tests::BoxRoom(10, 2.5f, 10);
  tests::AddBox({4, 0.7f, -7.5f}, {6, 0.75f, -7}, {90, 60, 30}, &table);
  const NearMap map = MapOf(table, StandingAt(5, -5));
  EXPECT_FALSE(map.IsExplorable(0));
  EXPECT_TRUE(map.IsExplorable(6));
}

TEST(NearMapTest, TargetsMayLieBesideFreeFloorIfTheConfigSaysSo) {
  const auto mesh = tests::BoxRoom(5.9f, 2.5f, 8);  // the wall is 2.95 m ahead
  DataConfig config;
  config.target_slack = 0.2;
  EXPECT_TRUE(MapOf(mesh, StandingAt(2.95, -4, 90), config).IsExplorable(0));
  config.target_slack = 0.1;
  EXPECT_FALSE(MapOf(mesh, StandingAt(2.95, -4, 90), config).IsExplorable(0));
}

TEST(NearMapTest, ABodyInACornerIsNotWalledIn) {
  const NearMap map = MapOf(tests::BoxRoom(10, 2.5f, 10), StandingAt(0.1, -0.1, 0));
  EXPECT_THAT(Explorable(map), testing::IsSupersetOf({10, 11}));
}

}  // namespace
}  // namespace bulletnav::bench
