// SPDX-License-Identifier: MIT
#include "benchmark/report/free_places.h"

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

const Eigen::AlignedBox2d kBounds(Point(0, 0), Point(100, 100));
const Point kSize(10, 10);

TEST(FreePlaces, TheFirstFreeMiddleIsChosenAndTaken) {
  FreePlaces places(kBounds);
  places.Take({50, 50}, kSize);
  const std::vector<Point> middles = {{55, 50}, {60, 50}, {40, 50}};
  EXPECT_EQ(places.Choose(middles, kSize), Point(60, 50)) << "boxes may touch";
  EXPECT_EQ(places.Choose(middles, kSize), Point(40, 50));
}

TEST(FreePlaces, WhereNoneIsFreeTheLeastIsCovered) {
  FreePlaces places(kBounds);
  places.Take({50, 50}, kSize);
  EXPECT_EQ(places.Choose(std::vector<Point>{{51, 50}, {58, 50}}, kSize), Point(58, 50));
}

TEST(FreePlaces, NothingLeavesTheBounds) {
  FreePlaces places(kBounds);
  EXPECT_EQ(places.Choose(std::vector<Point>{{98, 50}, {50, 50}}, kSize), Point(50, 50));
}

}  // namespace
}  // namespace bulletnav::bench
