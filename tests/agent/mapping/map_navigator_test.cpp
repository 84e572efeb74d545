// SPDX-License-Identifier: MIT
#include "agent/mapping/map_navigator.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/corridor.h"
#include "tests/support/rigs.h"

namespace bulletnav::agent {
namespace {

using sim::Action;

/// A navigator in the dark, fed with odometry alone.
class Blind {
 public:
  Blind() { Feel({}); }

  void Feel(const sim::PlanarPose& odometry, Action took = Action::kStop) {
    navigator.Took(took);
    navigator.Observe({{{}, depth_}, odometry, false, step_++});
  }
  bool IsWall(double x, double y) const {
    return navigator.map().IsFeltWall(navigator.map().CellAt({x, y}));
  }
  MapNavigator navigator{tests::SmallRig(), {}};

 private:
  std::vector<float> depth_ = std::vector<float>(8 * 32, 0.0f);
  int step_ = 0;
};

TEST(MapNavigator, AddsUpTheOdometry) {
  Blind body;
  for (int side = 0; side < 4; ++side) {
    body.Feel({1.0, 0.0, 0.0});
    body.Feel({0.0, 0.0, sim::kPi / 2});
    if (side == 1) {
      EXPECT_NEAR(body.navigator.pose().x, 1.0, 1e-12);
      EXPECT_NEAR(body.navigator.pose().y, 1.0, 1e-12);
    }
  }
  EXPECT_NEAR(body.navigator.pose().x, 0.0, 1e-12);
  EXPECT_NEAR(body.navigator.pose().y, 0.0, 1e-12);
  body.navigator.Reset();
  EXPECT_EQ(body.navigator.pose().x, 0.0);
}

TEST(MapNavigator, AShortForwardMoveFeltAWall) {
  Blind body;
  body.Feel({0.24, 0.0, 0.0}, Action::kMoveForward);
  EXPECT_FALSE(body.IsWall(0.16, 0.0));
  body.Feel({0.10, 0.0, 0.0}, Action::kMoveForward);
  EXPECT_TRUE(body.IsWall(0.24 + 0.16, 0.0));
  EXPECT_FALSE(body.IsWall(0.24 + 0.16, 0.06));
}

TEST(MapNavigator, TurnsFeelNoWalls) {
  Blind body;
  body.Feel({0.0, 0.0, 0.17}, Action::kTurnLeft);
  EXPECT_FALSE(body.IsWall(0.16, 0.0));
}

TEST(MapNavigator, TheWallGrowsWhileStuck) {
  Blind body;
  body.Feel({0.0, 0.025, 0.0});  // the middle of a cell
  for (int i = 0; i < 3; ++i) body.Feel({0.01, 0.0, 0.0}, Action::kMoveForward);
  EXPECT_TRUE(body.IsWall(0.18, 0.14));
  EXPECT_TRUE(body.IsWall(0.18, -0.12));
  EXPECT_FALSE(body.IsWall(0.18, 0.24));
  for (int i = 0; i < 9; ++i) body.Feel({0.0, 0.0, 0.0}, Action::kMoveForward);
  EXPECT_TRUE(body.IsWall(0.18, 0.22));
  EXPECT_FALSE(body.IsWall(0.18, 0.28)) << "nine cells at most";
  body.navigator.ForgetFeltWalls();
  EXPECT_FALSE(body.IsWall(0.18, 0.0));
}

TEST(MapNavigator, TurnsTowardsAPointAndThenGoes) {
  Blind body;
  MapNavigator& navigator = body.navigator;
  EXPECT_EQ(navigator.Steer({1.0, 0.0}), Action::kMoveForward);
  EXPECT_EQ(navigator.Steer({1.0, 0.26}), Action::kMoveForward);
  EXPECT_EQ(navigator.Steer({1.0, 0.28}), Action::kTurnLeft);
  EXPECT_EQ(navigator.Steer({1.0, -0.28}), Action::kTurnRight);
  EXPECT_EQ(navigator.Steer({-1.0, 0.01}), Action::kTurnRight) << "no wavering behind";
  EXPECT_EQ(navigator.Steer({-1.0, -0.01}), Action::kTurnRight);
  EXPECT_EQ(navigator.Steer({0.0, 1.0}), Action::kTurnLeft);
  EXPECT_EQ(navigator.Steer({-1.0, -0.01}), Action::kTurnLeft);
}

TEST(MapNavigator, RelativePlacesAreSeenFromThePose) {
  Blind body;
  body.Feel({1.0, 0.0, sim::kPi / 2});
  const Point p = body.navigator.PointAt(2.0, sim::kPi / 2);
  EXPECT_NEAR(p.x, -1.0, 1e-12);
  EXPECT_NEAR(p.y, 0.0, 1e-12);
}

TEST(MapNavigator, RefusesBrokenOdometry) {
  Blind body;
  EXPECT_THROW(body.Feel({std::nan(""), 0.0, 0.0}), sim::Error);
  EXPECT_THROW(body.Feel({1e9, 0.0, 0.0}), sim::Error);
}

TEST(MapNavigator, TheFrontierIsKeptUntilItIsExplored) {
  MapNavigator navigator({}, {});
  navigator.Reset();
  double x = 0.0;
  const auto look = [&](double ahead) {
    x += ahead;
    const auto depth = tests::CorridorDepth(x);
    navigator.Observe({{{}, depth}, {ahead, 0.0, 0.0}, false, 0});
  };
  look(0.0);
  const auto first = navigator.Frontier();
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->x, 3.15, 0.1) << "where the vision ends";
  EXPECT_LT(std::fabs(first->y), 0.75);
  EXPECT_EQ(navigator.Frontier()->x, first->x);
  look(1.0);
  const auto next = navigator.Frontier();
  ASSERT_TRUE(next);
  EXPECT_NEAR(next->x, 4.15, 0.1);
}

/// The depth seen in the middle of a room of 5 x 4 m without doors.
std::vector<float> RoomDepth(float yaw) {
  static const auto scene = sim::MakeRenderScene(tests::BoxRoom(4, 2.6f, 5), sim::Backend::kEmbree);
  return tests::RenderPanorama(*scene, {}, {{2.0f, 1.25f, -2.5f}, yaw}).depth;
}

TEST(MapNavigator, DoubtsAMapThatDriftHasTurned) {
  MapNavigator navigator({}, {});
  navigator.Reset();
  const auto look = [&](const std::vector<float>& depth, double ahead = 0.0) {
    navigator.Observe({{{}, depth}, {ahead, 0.0, 0.0}, false, 0});
  };
  for (int i = 0; i < 8; ++i) look(RoomDepth(0.0f));
  const sim::Cell corner = navigator.map().CellAt({2.4, 1.9});
  EXPECT_TRUE(navigator.map().IsExplored(corner));
  const auto turned = RoomDepth(0.7f);  // the odometry has not felt it
  for (int i = 0; i < 4; ++i) look(turned);
  const sim::Cell beyond = navigator.map().CellAt({2.45, -1.9});
  EXPECT_FALSE(navigator.map().IsExplored(beyond) && navigator.map().IsExplored(corner))
      << "what was mapped before is outside the walls that are seen";
}

TEST(MapNavigator, KeepsAMapThatAgreesWithWhatIsSeen) {
  MapNavigator navigator({}, {});
  navigator.Reset();
  for (int i = 0; i < 8; ++i) {
    const auto depth = tests::CorridorDepth(0.25 * i);
    navigator.Observe({{{}, depth}, {i == 0 ? 0.0 : 0.25, 0.01 * (i % 2), 0.005}, false, i});
  }
  EXPECT_TRUE(navigator.map().IsExplored(navigator.map().CellAt({-0.5, 0.0}))) << "long past";
}

TEST(MapNavigator, OpeningsAreWhereKnownFloorEnds) {
  MapNavigator navigator({}, {});
  navigator.Reset();
  const auto depth = tests::CorridorDepth(0.0);
  navigator.Observe({{{}, depth}, {}, false, 0});
  EXPECT_TRUE(navigator.Openings(2.5, 1.0).empty());
  const std::vector<Point> openings = navigator.Openings(4.0, 2.0);
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_NEAR(openings[0].x, 3.15, 0.1) << "where the vision ends";
}

TEST(MapNavigator, AFrontierThatStaysUnseenFromNearbyIsGivenUp) {
  Blind body;  // sees nothing at all: the rim of its own track is frontier wherever it stands
  for (int i = 0; i < 40; ++i) body.Feel({0.05, 0.0, 0.0});
  std::optional<Point> frontier = body.navigator.Frontier();
  int given_up = 0;
  while (frontier && Distance(*frontier, body.navigator.here()) < 0.3 && ++given_up < 60) {
    frontier = body.navigator.Frontier();
  }
  EXPECT_LT(given_up, 60);
}

TEST(MapNavigator, AFrontierThatTheBodyCannotGetNearerToIsGivenUp) {
  MapNavigator navigator({}, {});
  navigator.Reset();
  const auto depth = tests::CorridorDepth(0.0);
  int steps = 0;
  for (; steps < 200; ++steps) {  // something unseen holds the body
    navigator.Observe({{{}, depth}, {}, false, steps});
    if (!navigator.ToFrontier()) break;
  }
  EXPECT_GT(steps, 20);
  EXPECT_LT(steps, 200) << "there is but one end of the corridor";
}

TEST(NavigatorSpec, RefusesNonsense) {
  NavigatorSpec spec;
  EXPECT_NO_THROW(spec.Validate());
  spec.turn_threshold_deg = 2.0;
  EXPECT_THROW(spec.Validate(), sim::Error);
  spec = {};
  spec.ahead = 0.0;
  EXPECT_THROW(spec.Validate(), sim::Error);
  EXPECT_THROW((MapSpec{.cell = 0.0}.Validate()), sim::Error);
  EXPECT_THROW((MapSpec{.size = 5.0}.Validate()), sim::Error);
  EXPECT_THROW((MapSpec{.obstacle_low = 2.0}.Validate()), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
