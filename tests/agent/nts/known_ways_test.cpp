// SPDX-License-Identifier: MIT
#include "agent/nts/known_ways.h"

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

TEST(KnownWays, KnowNothingOfPlacesThatWereNotAskedAbout) {
  KnownWays ways;
  EXPECT_EQ(ways.Least({0, 0}, {3, 0}), 0.0);
  ways.Learn({0, 0}, {3, 0}, 9.0);
  EXPECT_EQ(ways.Least({0, 0}, {3, 1.1}), 0.0);
  ways.Clear();
  EXPECT_EQ(ways.Least({0, 0}, {3, 0}), 0.0);
}

TEST(KnownWays, AreShorterByAtMostWhatLiesBetween) {
  KnownWays ways;
  ways.Learn({0, 0}, {3, 0}, 9.0);
  EXPECT_DOUBLE_EQ(ways.Least({0, 0}, {3, 0}), 9.0);
  EXPECT_DOUBLE_EQ(ways.Least({0, 2}, {3, 0}), 7.0);
  EXPECT_DOUBLE_EQ(ways.Least({0, 2}, {3.5, 0}), 6.5);
  EXPECT_EQ(ways.Least({-20, 0}, {3, 0}), 0.0) << "from there nothing is known";
}

TEST(KnownWays, TheNewestCounts) {
  KnownWays ways;
  ways.Learn({0, 0}, {3, 0}, 9.0);
  ways.Learn({0, 1}, {3.2, 0}, 4.0);
  EXPECT_DOUBLE_EQ(ways.Least({0, 1}, {3.2, 0}), 4.0);
  ways.Learn({0, 1}, {5, 0}, 30.0);
  EXPECT_DOUBLE_EQ(ways.Least({0, 1}, {3.2, 0}), 4.0) << "another place";
}

}  // namespace
}  // namespace bulletnav::agent
