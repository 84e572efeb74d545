// SPDX-License-Identifier: MIT
#include "agent/mapping/progress_watch.h"

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

TEST(ProgressWatch, IsPatientWhileTheTargetComesNearer) {
  ProgressWatch watch(3, 0.2);
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(watch.IsStuck(1, 20.0 - 0.1 * i));
}

TEST(ProgressWatch, LosesPatienceAfterSoManyStepsAndThenBeginsAnew) {
  ProgressWatch watch(3, 0.2);
  EXPECT_FALSE(watch.IsStuck(1, 5.0));
  EXPECT_FALSE(watch.IsStuck(1, 4.9));
  EXPECT_FALSE(watch.IsStuck(1, 5.1));
  EXPECT_TRUE(watch.IsStuck(1, 4.9));
  EXPECT_FALSE(watch.IsStuck(1, 4.9));
}

TEST(ProgressWatch, NoticesWaveringBetweenTwoTargets) {
  ProgressWatch watch(3, 0.2);
  int stuck = 0;
  for (int i = 0; i < 8; ++i) stuck += watch.IsStuck(i % 2, 5.0) ? 1 : 0;
  EXPECT_EQ(stuck, 2);
}

TEST(ProgressWatch, TheWayBackToATargetIsProgress) {
  ProgressWatch watch(3, 0.2);
  EXPECT_FALSE(watch.IsStuck(1, 1.0));
  for (int i = 0; i < 10; ++i) watch.IsStuck(2, 5.0 - 0.5 * i);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(watch.IsStuck(1, 6.0 - 0.25 * i)) << i;
}

TEST(ProgressWatch, FloorThatIsSeenForTheFirstTimeIsProgress) {
  ProgressWatch watch(3, 0.2);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(watch.IsStuck(1, 5.0 + 0.25 * i, 1.0 * i)) << i;
  EXPECT_FALSE(watch.IsStuck(1, 9.75, 19.0));
  EXPECT_TRUE(watch.IsStuck(1, 9.75, 19.0)) << "what little was seen counts once";
}

TEST(ProgressWatch, WhatWasSeenOnALongWayRoundDoesNotRaiseTheMark) {
  ProgressWatch watch(3, 0.2);
  EXPECT_FALSE(watch.IsStuck(1, 5.0, 0.0));
  EXPECT_FALSE(watch.IsStuck(1, 8.0, 2.0));
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(watch.IsStuck(1, 7.75 - 0.25 * i, 2.0)) << i;
}

TEST(ProgressWatch, ForgetsOneTarget) {
  ProgressWatch watch(2, 0.2);
  watch.IsStuck(1, 5.0);
  watch.IsStuck(1, 5.0);
  watch.Forget(1);
  EXPECT_FALSE(watch.IsStuck(1, 5.0));
  EXPECT_FALSE(watch.IsStuck(1, 5.0));
  EXPECT_TRUE(watch.IsStuck(1, 5.0));
}

TEST(ProgressWatch, ForgetsOnReset) {
  ProgressWatch watch(1, 0.2);
  EXPECT_FALSE(watch.IsStuck(1, 5.0));
  watch.Reset();
  EXPECT_FALSE(watch.IsStuck(1, 5.0));
}

}  // namespace
}  // namespace bulletnav::agent
