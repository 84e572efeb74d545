// SPDX-License-Identifier: MIT
#include "benchmark/slam/plots/room_figure.h"

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

/// Two rooms side by side, a metre of wall between them, and a third that nobody enters.
sim::FloorPlan TwoRooms() {
  const auto square = [](float left) {
    return std::vector<sim::PlanPoint>{
        {left, 0.0f}, {left, 4.0f}, {left + 4.0f, 4.0f}, {left + 4.0f, 0.0f}};
  };
  sim::FloorPlan plan;
  plan.rooms = {{sim::RoomType::kKitchen, "kitchen", square(0.0f)},
                {sim::RoomType::kToilet, "toilet", square(20.0f)},
                {sim::RoomType::kBedroom, "bedroom_1", square(5.0f)}};
  return plan;
}

std::vector<sim::BodyPose> Walk(const std::vector<double>& xs) {
  std::vector<sim::BodyPose> poses;
  poses.reserve(xs.size());
  for (const double x : xs) poses.push_back({.position = {x, 0.0, 2.0}, .yaw = 0.0});
  return poses;
}

TEST(CountRooms, CountsFramesOfClustersInRoomsThatWereEntered) {
  // Cluster 0: two in the kitchen, one between; cluster 1: three in the bedroom, one in the
  // kitchen.
  const agent::SequenceTrace trace{{{0, 2, 0}, {3, 6, 1}}, {}, {}, {}};
  const RoomCounts counts = CountRooms(trace, Walk({1, 2, 4.5, 6, 7, 8, 3}), TwoRooms());
  EXPECT_EQ(counts.rooms, (std::vector<std::string>{"kitchen", "bedroom_1"}));
  EXPECT_EQ(counts.frames, (std::vector<std::vector<int>>{{2, 0}, {1, 3}}));
  EXPECT_EQ(counts.between, 1);
  EXPECT_DOUBLE_EQ(counts.purity, 5.0 / 6.0);
}

TEST(CountRooms, OfNothingIsNothing) {
  EXPECT_EQ(CountRooms({}, Walk({1}), TwoRooms()).purity, 0.0);
  const agent::SequenceTrace trace{{{0, 1, 0}}, {}, {}, {}};
  EXPECT_EQ(CountRooms(trace, Walk({50, 51}), TwoRooms()).between, 2);
  EXPECT_EQ(CountRooms(trace, {}, TwoRooms()).between, 0);
}

/// What is dark where: the kitchen's column in the first row, the bedroom's in the second.
TEST(RoomFigure, IsDarkWhereAClusterIs) {
  const agent::SequenceTrace trace{{{0, 1, 1}, {2, 3, 0}}, {}, {}, {}};
  const Figure figure = RoomFigure(Walk({1, 2, 6, 7}), {{"hut", trace}}, TwoRooms());
  const sim::Image image = ToImage(figure, 1.0);
  const auto red = [&image](int x, int y) {
    return static_cast<int>(*image.at(y, x));
  };
  const int left = 16 + 24;  // of the panel; 34 above it; 420 wide and high
  EXPECT_LT(red(left + 100, 34 + 100), 20);
  EXPECT_GT(red(left + 300, 34 + 100), 230);
  EXPECT_GT(red(left + 100, 34 + 300), 230);
  EXPECT_LT(red(left + 300, 34 + 300), 20);
}

}  // namespace
}  // namespace bulletnav::bench
