// SPDX-License-Identifier: MIT
#include "agent/mapping/goal_approach.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/panoramas.h"
#include "tests/support/rigs.h"
#include "tests/support/scenes.h"

namespace bulletnav::agent {
namespace {

using sim::Action;

/// A body on an endless floor whose odometry is exact, with somebody who tells it of a goal.
class GoalApproachTest : public testing::Test {
 protected:
  /// Steps while the approach knows where to go; at most 100. `certainty`: of a sighting from so
  /// many metres away; 0: none.
  void Run(const Point& goal, const std::function<double(double)>& certainty) {
    for (steps_ = 0; steps_ < 100; ++steps_) {
      navigator_.Observe({{{}, depth_}, motion_, false, steps_});
      const double distance = Distance(goal, navigator_.here());
      const double heading = std::atan2(goal.y - navigator_.here().y, goal.x - navigator_.here().x);
      const RelativeGoal seen{std::min(distance, farthest_told_),
                              sim::WrapAngle(heading - navigator_.pose().yaw), certainty(distance)};
      approach_.See(seen.certainty > 0.0 ? std::optional(seen) : std::nullopt, navigator_);
      last_ = approach_.Act(&navigator_);
      motion_ = {};
      if (!last_ || last_ == Action::kStop) return;
      navigator_.Took(*last_);
      constexpr double kTurn = sim::DegToRad(10.0);
      if (last_ == Action::kMoveForward) motion_.x = is_held_ ? 0.0 : 0.25;
      if (last_ == Action::kTurnLeft) motion_.yaw = kTurn;
      if (last_ == Action::kTurnRight) motion_.yaw = -kTurn;
    }
  }
  double Left(const Point& goal) const { return Distance(goal, navigator_.here()); }

  ApproachSpec spec_ = {.sightings = 1};
  GoalApproach approach_{spec_};
  MapNavigator navigator_{tests::SmallRig(), {}};
  std::vector<float> depth_ = std::vector<float>(8 * 32, 0.0f);
  sim::PlanarPose motion_;
  std::optional<Action> last_;
  int steps_ = 0;
  double farthest_told_ = 100.0;  // metres
  bool is_held_ = false;          // something unseen is in the way, wherever it goes
};

TEST_F(GoalApproachTest, WalksToAGoalAndStopsNearIt) {
  const Point goal{2.0, 2.0};
  Run(goal, [](double) {
    return 0.99;
  });
  EXPECT_EQ(last_, Action::kStop);
  EXPECT_LE(Left(goal), 0.5);
  EXPECT_GT(Left(goal), 0.2);
  EXPECT_LT(steps_, 20);
}

TEST_F(GoalApproachTest, KnowsNowhereToGoBeforeTheGoalIsSeenAndAfterReset) {
  Run({3.0, 0.0}, [](double) {
    return 0.0;
  });
  EXPECT_EQ(steps_, 0);
  EXPECT_FALSE(last_);
  Run({3.0, 0.0}, [](double distance) {
    return distance > 2.0 ? 0.6 : 0.0;
  });
  approach_.Reset();
  EXPECT_FALSE(approach_.target());
  EXPECT_TRUE(approach_.MayBeAt({3.0, 0.0}, 2.0, 0.6));
}

TEST_F(GoalApproachTest, RemembersWhereTheGoalWas) {
  const Point goal{4.0, 0.0};
  Run(goal, [](double distance) {
    return distance > 3.0 ? 0.6 : distance > 1.4 ? 0.0 : 0.99;
  });
  EXPECT_EQ(last_, Action::kStop);
  EXPECT_LE(Left(goal), 0.5);
}

TEST_F(GoalApproachTest, WhatIsNotCertainThereIsNotTheGoal) {
  const Point goal{3.0, 0.0};
  Run(goal, [](double) {
    return 0.8;
  });
  EXPECT_FALSE(last_);
  EXPECT_LE(Left(goal), kAtGoal);
  EXPECT_FALSE(approach_.target());
  EXPECT_FALSE(approach_.MayBeAt(goal, 2.0, 0.8));
  EXPECT_TRUE(approach_.MayBeAt(goal, 2.0, 0.99));
}

TEST_F(GoalApproachTest, WhatWouldBeSeenFromNearButIsNotIsGivenUpOnTheWay) {
  const Point goal{4.0, 0.0};
  Run(goal, [](double distance) {
    return distance > 3.0 ? 0.6 : 0.0;
  });
  EXPECT_FALSE(last_);
  EXPECT_NEAR(Left(goal), spec_.miss_within - 0.25 * (spec_.misses - 1), 0.26);
  EXPECT_FALSE(approach_.MayBeAt(goal, 2.0, 0.6));
}

TEST_F(GoalApproachTest, AfterAStopInVainItGoesNearerAndThenLooksElsewhere) {
  const Point goal{2.0, 0.0};
  const auto lie = [](double) {
    return 0.99;
  };
  Run(goal, lie);
  ASSERT_EQ(last_, Action::kStop);
  const double left = Left(goal);
  navigator_.Took(Action::kStop);
  Run(goal, lie);
  EXPECT_FALSE(last_) << "not another stop";
  EXPECT_LT(Left(goal), left);
  EXPECT_FALSE(approach_.MayBeAt(goal, 0.3, 0.999)) << "whatever is said";
  const Point other{-2.0, 0.0};
  Run(other, lie);
  EXPECT_EQ(last_, Action::kStop);
  EXPECT_LE(Left(other), 0.5);
}

TEST_F(GoalApproachTest, AGoalSeenFromAfarIsGoneToAlthoughItIsToldTooNear) {
  const Point goal{14.0, 3.0};
  farthest_told_ = 3.0;
  steps_ = 0;
  Run(goal, [](double distance) {
    return distance > 3.0 ? 0.8 : 0.99;
  });
  EXPECT_EQ(last_, Action::kStop);
  EXPECT_LE(Left(goal), 0.6);
}

TEST(GoalApproach, LooksBehindACounterOnWhichTheGoalSeemsToStand) {
  // A room whose middle is the plane's origin, and a counter from x = 0.9 to 1.5 in the plane.
  sim::SceneMesh mesh = tests::BoxRoom(8, 2.6f, 8);
  tests::AddBox({2.8f, 0, -5.5f}, {5.2f, 1.1f, -4.9f}, {9, 9, 9}, &mesh);
  const auto scene = sim::MakeRenderScene(mesh, sim::Backend::kEmbree);
  const Point goal{1.95, 0.0};
  GoalApproach approach({.sightings = 1});
  MapNavigator navigator({}, {});
  sim::PlanarPose motion;
  int steps = 0;
  for (; steps < 150; ++steps) {
    const sim::PlanarPose before = sim::Compose(navigator.pose(), motion);
    const auto depth =
        tests::RenderPanorama(
            *scene, {},
            {{4.0f - static_cast<float>(before.y), 1.25f, -4.0f - static_cast<float>(before.x)},
             static_cast<float>(before.yaw)})
            .depth;
    navigator.Observe({{{}, depth}, motion, false, steps});
    // From before the counter it is told too near, and not for sure.
    const bool is_behind = navigator.here().x > 1.5;
    const Point told = is_behind ? goal : Point{1.25, 0.0};
    const double heading = std::atan2(told.y - navigator.here().y, told.x - navigator.here().x);
    approach.See(
        RelativeGoal{Distance(told, navigator.here()),
                     sim::WrapAngle(heading - navigator.pose().yaw), is_behind ? 0.99 : 0.7},
        navigator);
    const auto action = approach.Act(&navigator);
    ASSERT_TRUE(action) << "given up after " << steps;
    if (action == Action::kStop) break;
    navigator.Took(*action);
    constexpr double kTurn = sim::DegToRad(10.0);
    motion = {};
    const Point next = navigator.PointAt(0.25, 0.0);
    const bool is_counter = next.x > 0.8 && next.x < 1.6 && std::fabs(next.y) < 1.3;
    if (action == Action::kMoveForward && !is_counter) motion.x = 0.25;
    if (action == Action::kTurnLeft) motion.yaw = kTurn;
    if (action == Action::kTurnRight) motion.yaw = -kTurn;
  }
  EXPECT_LT(steps, 100);
  EXPECT_LE(Distance(goal, navigator.here()), 0.6);
}

TEST_F(GoalApproachTest, AGoalThatIsSeenButCannotBeGotToIsSetAside) {
  const Point goal{2.0, 0.0};
  const auto truth = [](double) {
    return 0.99;
  };
  is_held_ = true;
  Run(goal, truth);
  EXPECT_FALSE(last_) << "it looks for another way";
  EXPECT_LT(steps_, 100);
  EXPECT_TRUE(approach_.target());
  EXPECT_FALSE(approach_.MayBeAt(goal, 2.0, 0.99)) << "whoever else says so";
  Run(goal, truth);
  EXPECT_EQ(steps_, 0) << "nothing more has been seen";
  approach_.Reconsider();
  is_held_ = false;
  motion_ = {};
  Run(goal, truth);
  EXPECT_EQ(last_, Action::kStop);
  EXPECT_LE(Left(goal), 0.5);
}

}  // namespace
}  // namespace bulletnav::agent
