// SPDX-License-Identifier: MIT
#include "agent/mapping/goal_track.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

TEST(GoalTrack, WaitsForSightingsThatAgree) {
  GoalTrack track(2, 0.9);
  EXPECT_FALSE(track.point());
  track.Add({1, 1}, 2.0, 0.6);
  EXPECT_FALSE(track.point());
  track.Add({5, 1}, 2.0, 0.6);
  EXPECT_FALSE(track.point());
  track.Add({1.2, 1}, 2.0, 0.6);
  ASSERT_TRUE(track.point());
  EXPECT_NEAR(track.point()->x, 1.11, 0.02);
  track.Reset();
  EXPECT_FALSE(track.point());
}

TEST(GoalTrack, AveragesSightingsThatErr) {
  double single = 0.0;
  double mean = 0.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    sim::Rng rng(seed, "track");
    GoalTrack track(1, 0.9);
    Point last;
    for (int i = 0; i < 12; ++i) {
      last = {0.3 * rng.Normal(), 0.3 * rng.Normal()};
      track.Add(last, 2.0, 0.6);
    }
    single += std::hypot(last.x, last.y) / 200;
    mean += std::hypot(track.point()->x, track.point()->y) / 200;
  }
  EXPECT_LT(mean, 0.5 * single);
}

TEST(GoalTrack, BelievesNearSightingsMore) {
  GoalTrack track(1, 0.9);
  track.Add({0, 0}, 3.0, 0.6);
  track.Add({1, 0}, 0.5, 0.6);
  EXPECT_GT(track.point()->x, 0.9);
}

TEST(GoalTrack, MovesWhenSightingsStayElsewhere) {
  GoalTrack track(1, 0.9);
  for (int i = 0; i < 10; ++i) track.Add({0, 0}, 2.0, 0.6);
  track.Add({4, 0}, 2.0, 0.6);
  track.Add({4, 0}, 2.0, 0.6);
  EXPECT_NEAR(track.point()->x, 0.0, 1e-9);
  track.Add({4, 0}, 2.0, 0.6);
  EXPECT_NEAR(track.point()->x, 4.0, 1e-9);
}

TEST(GoalTrack, WhatWasRefutedTakesCertainty) {
  GoalTrack track(1, 0.9);
  track.Add({0, 0}, 2.0, 0.6);
  track.Refute();
  track.Add({0.2, 0}, 2.0, 0.8);
  EXPECT_FALSE(track.point());
  track.Add({3, 0}, 2.0, 0.6);
  EXPECT_NEAR(track.point()->x, 3.0, 1e-9);
  track.Refute();
  track.Add({0.2, 0}, 2.0, 0.95);
  EXPECT_NEAR(track.point()->x, 0.2, 1e-9);
  track.Reset();
  track.Add({3, 0}, 2.0, 0.6);
  EXPECT_TRUE(track.point());
}

TEST(GoalTrack, WhatWasRefutedTwiceMustBeSeenFromBeside) {
  GoalTrack track(1, 0.9);
  for (int i = 0; i < 2; ++i) {
    track.Add({0, 0}, 2.0, 0.95);
    ASSERT_TRUE(track.point());
    track.Refute();
  }
  track.Add({0.2, 0}, 2.0, 0.99);
  EXPECT_FALSE(track.point());
  track.Add({0.2, 0}, 0.4, 0.6);
  EXPECT_FALSE(track.point());
  track.Add({0.2, 0}, 0.4, 0.99);
  EXPECT_TRUE(track.point());
}

TEST(GoalTrack, SaysWhenTheGoalIsTakenToBeElsewhere) {
  GoalTrack track(1, 0.9);
  EXPECT_TRUE(track.Add({0, 0}, 2.0, 0.6));
  EXPECT_FALSE(track.Add({0.1, 0}, 2.0, 0.6));
  EXPECT_FALSE(track.Add({4, 0}, 2.0, 0.6));
  EXPECT_FALSE(track.Add({4, 0}, 2.0, 0.6));
  EXPECT_TRUE(track.Add({4, 0}, 2.0, 0.6));
}

TEST(GoalTrack, APlaceCanBeRefutedThatItDoesNotTakeForTheGoals) {
  GoalTrack track(1, 0.9);
  track.Add({4, 0}, 2.0, 0.6);
  track.RefuteAt({0, 0});
  EXPECT_TRUE(track.point());
  EXPECT_FALSE(track.IsNews({0.5, 0}, 2.0, 0.6));
  EXPECT_TRUE(track.IsNews({0.5, 0}, 2.0, 0.95));
  track.RefuteAt({4.5, 0});
  EXPECT_FALSE(track.point());
}

TEST(GoalTrack, NothingIsNewsAroundAStopInVainUntilTheNextGoal) {
  GoalTrack track(1, 0.9);
  track.Add({0, 0}, 0.3, 0.99);
  track.RefuteForGood();
  EXPECT_FALSE(track.point());
  EXPECT_FALSE(track.IsNews({0.5, 0}, 0.1, 0.999));
  EXPECT_TRUE(track.IsNews({0.8, 0}, 0.3, 0.99));
  track.Reset();
  EXPECT_TRUE(track.IsNews({0.5, 0}, 2.0, 0.6));
}

}  // namespace
}  // namespace bulletnav::agent
