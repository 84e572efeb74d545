// SPDX-License-Identifier: MIT
#include "agent/mapping/map_navigator.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

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

constexpr MapSpec kSmallMap{.size = 13.0};

/// All floor, as far as the vision reaches: whatever stands there is not seen.
class FloorEverywhere final : public ViewWindow {
 public:
  explicit FloorEverywhere(const MapSpec& spec)
      : ViewWindow(static_cast<int>(spec.vision / spec.cell)) {
    floor_points_.Fill(9);
    seen_.Fill(1);
  }
  void Project(const Panorama& /*panorama*/, double /*x*/, double /*y*/, double /*yaw*/) override {}
};

/// Something lower than is seen, or a pit, which a body of 0.18 m radius cannot enter.
struct Unseen {
  double low_x, high_x, low_y, high_y;

  bool Holds(const sim::PlanarPose& body) const {
    const double x = body.x - std::clamp(body.x, low_x, high_x);
    const double y = body.y - std::clamp(body.y, low_y, high_y);
    return std::hypot(x, y) < 0.18;
  }
};

struct Walk {
  bool arrived = false;
  int steps = 0;
  int bumps = 0;
};

/// A body in a plane among things that it does not see.
class BlindWalker {
 public:
  explicit BlindWalker(std::vector<Unseen> things) : things_(std::move(things)) {
    navigator_.Reset();
    navigator_.Observe({});
  }

  /// From the origin to a goal, until it is there or 500 steps are over.
  Walk WalkTo(const Point& goal) {
    Walk walk;
    for (; walk.steps < 500; ++walk.steps) {
      walk.arrived = Distance(navigator_.here(), goal) < 0.3;
      if (walk.arrived) break;
      auto plan = navigator_.Plan(goal, true);
      if (!plan) {
        navigator_.ForgetMap();
        plan = navigator_.Plan(goal, true);
      }
      if (!plan) break;
      walk.bumps += Bumps(navigator_.Steer(plan->point)) ? 1 : 0;
    }
    return walk;
  }

 private:
  bool Bumps(Action action) {
    const sim::PlanarPose before = body_;
    bool bumps = false;
    if (action == Action::kMoveForward) {
      for (int i = 0; i < 25 && !bumps; ++i) {
        const sim::PlanarPose next = sim::Compose(body_, {0.01, 0.0, 0.0});
        bumps = std::any_of(things_.begin(), things_.end(), [&](const Unseen& thing) {
          return thing.Holds(next);
        });
        if (!bumps) body_ = next;
      }
    } else {
      body_.yaw += sim::DegToRad(action == Action::kTurnLeft ? 10.0 : -10.0);
    }
    navigator_.Took(action);
    navigator_.Observe({{}, sim::Compose(sim::Inverse(before), body_), false, 0});
    return bumps;
  }

  MapNavigator navigator_{
      {.map = kSmallMap, .feel_edges = true}, std::make_unique<FloorEverywhere>(kSmallMap), false};
  std::vector<Unseen> things_;
  sim::PlanarPose body_;
};

TEST(MapNavigator, FeelsItsWayRoundWhatItDoesNotSee) {
  for (const double half_width : {0.3, 1.0, 2.5}) {
    for (const double aside : {0.0, 0.2}) {
      BlindWalker walker({{1.5, 2.5, aside - half_width, aside + half_width}});
      const Walk walk = walker.WalkTo({4.0, 0.0});
      EXPECT_TRUE(walk.arrived) << half_width << " m to both sides of " << aside;
      EXPECT_LE(walk.bumps, 30) << half_width << " m to both sides of " << aside;
    }
  }
}

TEST(MapNavigator, FeelsItsWayOutOfAPocket) {
  for (const double depth : {0.5, 1.5}) {
    for (const double half_width : {0.6, 1.2}) {
      const double low = 2.0 - depth;
      BlindWalker walker({{2.0, 2.3, -half_width, half_width},
                          {low, 2.3, half_width, half_width + 0.2},
                          {low, 2.3, -half_width - 0.2, -half_width}});
      EXPECT_TRUE(walker.WalkTo({4.0, 0.1}).arrived) << depth << " m deep, " << half_width;
    }
  }
}

TEST(MapNavigator, AFewPushesCloseNoDoor) {
  for (const double aside : {0.0, 0.3, -0.3}) {
    BlindWalker walker({{1.5, 1.6, aside + 0.45, 9.0}, {1.5, 1.6, -9.0, aside - 0.45}});
    EXPECT_TRUE(walker.WalkTo({3.2, 0.0}).arrived) << aside;
  }
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
