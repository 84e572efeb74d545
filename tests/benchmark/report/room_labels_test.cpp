// SPDX-License-Identifier: MIT
#include "benchmark/report/room_labels.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

using Point = Eigen::Vector2f;
using Outline = std::vector<Point>;

Outline Rectangle(float x0, float y0, float x1, float y1) {
  return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}};
}

TEST(PoleOfInaccessibility, IsTheMiddleOfARectangle) {
  EXPECT_LT((PoleOfInaccessibility(Rectangle(1, 2, 7, 4)) - Point(4, 3)).norm(), 0.06f);
  EXPECT_LT((PoleOfInaccessibility(Rectangle(-1, -1, 1, 1)) - Point(0, 0)).norm(), 0.06f);
}

TEST(PoleOfInaccessibility, IsInTheWideArmOfAnL) {
  // An arm of 1 m along x, one of 3 m along y.
  const Outline outline = {{0, 0}, {0, 6}, {3, 6}, {3, 1}, {8, 1}, {8, 0}};
  const Point pole = PoleOfInaccessibility(outline);
  EXPECT_TRUE(sim::IsInside(outline, pole));
  EXPECT_NEAR(pole.x(), 1.5f, 0.1f);
  EXPECT_GT(pole.y(), 1.4f);
}

TEST(PoleOfInaccessibility, IsInsideAUWhoseMiddleIsNot) {
  const Outline outline = {{0, 0}, {0, 4}, {1, 4}, {1, 1}, {3, 1}, {3, 4}, {4, 4}, {4, 0}};
  EXPECT_FALSE(sim::IsInside(outline, Point(2, 2)));
  EXPECT_TRUE(sim::IsInside(outline, PoleOfInaccessibility(outline)));
}

TEST(PoleOfInaccessibility, TakesARoomSmallerThanItsGrid) {
  const Outline outline = Rectangle(0, 0, 0.02f, 0.02f);
  EXPECT_TRUE(sim::IsInside(outline, PoleOfInaccessibility(outline)));
}

TEST(RoomLabels, SayTheTypeInWords) {
  sim::FloorPlan plan;
  plan.rooms.push_back({sim::RoomType::kLivingRoom, "living_room_2", Rectangle(0, 0, 4, 4)});
  plan.rooms.push_back({sim::RoomType::kStudy, "study", Rectangle(4, 0, 6, 4)});
  const std::vector<MapLabel> labels = RoomLabels(plan);
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].text, "living room");
  EXPECT_EQ(labels[1].text, "study");
  EXPECT_EQ(labels[1].inside, plan.rooms[1].outline);
}

/// Box of the pixels in which two pictures differ.
Eigen::AlignedBox2i Difference(const sim::Image& a, const sim::Image& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  Eigen::AlignedBox2i box;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (!std::equal(a.at(x, y), a.at(x, y) + 3, b.at(x, y))) box.extend(Eigen::Vector2i(x, y));
    }
  }
  return box;
}

/// A map of a room of 4 m x 3 m at a centimetre a pixel, x from 0, z from -3, and 0.5 m of margin.
class TopDownLabelTest : public testing::Test {
 protected:
  sim::Image Draw(const std::vector<MapLabel>& labels) const {
    return DrawTopDown(mesh_, navmesh_, labels);
  }

 private:
  const sim::SceneMesh mesh_ = tests::BoxRoom(4.0f, 2.6f, 3.0f);
  const sim::Navmesh navmesh_{mesh_, {}};
};

TEST_F(TopDownLabelTest, PrintsALabelCentredAtItsPlace) {
  const MapLabel label{"dining room", {2.0f, -1.5f}, Rectangle(0, -3, 4, 0)};
  const auto ink = Difference(Draw({}), Draw({label}));
  ASSERT_FALSE(ink.isEmpty());
  EXPECT_NEAR(0.5 * (ink.min().x() + ink.max().x()), 250.0, 2.0);
  EXPECT_NEAR(0.5 * (ink.min().y() + ink.max().y()), 200.0, 2.0);
}

TEST_F(TopDownLabelTest, PrintsSmallerWhereSpaceIsShort) {
  const Point at(2.0f, -1.5f);
  const auto plain = Difference(Draw({}), Draw({{"bathroom", at, {}}}));
  const float half = 0.5f * 0.01f * static_cast<float>(plain.sizes().x()) - 0.05f;
  const auto small =
      Difference(Draw({}), Draw({{"bathroom", at, Rectangle(2 - half, -3, 2 + half, 0)}}));
  ASSERT_FALSE(small.isEmpty());
  EXPECT_LT(small.sizes().x(), plain.sizes().x());
}

TEST_F(TopDownLabelTest, LeavesOutWhatDoesNotFit) {
  const MapLabel label{"dining room", {2.0f, -1.5f}, Rectangle(1.8f, -3, 2.2f, 0)};
  EXPECT_TRUE(Difference(Draw({}), Draw({label})).isEmpty());
}

}  // namespace
}  // namespace bulletnav::bench
