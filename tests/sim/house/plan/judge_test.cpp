// SPDX-License-Identifier: MIT
#include "sim/house/plan/judge.h"

#include <gtest/gtest.h>

namespace bulletnav::sim::plan {
namespace {

constexpr int kLiving = 0;
constexpr int kKitchen = 1;
constexpr int kBath = 2;
constexpr int kBed = 3;

/// A small flat by hand: living room and kitchen west of a corridor, bath and bedroom east.
Draft GoodFlat() {
  Draft draft;
  draft.rooms = {{RoomType::kLivingRoom, 24.0f, {{0, 0, 500, 500}}},
                 {RoomType::kKitchen, 12.0f, {{0, 500, 500, 750}}},
                 {RoomType::kBathroom, 6.0f, {{640, 0, 960, 220}}},
                 {RoomType::kBedroom, 16.0f, {{640, 220, 960, 750}}},
                 {RoomType::kCorridor, 8.0f, {{500, 0, 640, 750}}}};
  return draft;
}

TEST(Judge, AcceptsAGoodFlat) {
  const auto layout = Judge(GoodFlat(), {});
  ASSERT_TRUE(layout.has_value());
  EXPECT_NEAR(layout->SharedWall(kLiving, kKitchen), 4.88f, 1e-4f);
  EXPECT_EQ(layout->SharedWall(kLiving, kBed), 0.0f);
  EXPECT_NEAR(ClearArea(layout->draft, kLiving), 4.88f * 4.88f, 1e-3f);
}

TEST(Judge, RefusesBadOnes) {
  Draft draft = GoodFlat();
  std::swap(draft.rooms[kKitchen].boxes, draft.rooms[kBed].boxes);
  EXPECT_FALSE(Judge(draft, {}).has_value()) << "the kitchen is away from the living room";
  draft = GoodFlat();
  draft.rooms[kBath].boxes[0].y1 = 330;
  EXPECT_FALSE(Judge(draft, {}).has_value()) << "rooms overlap";
  draft = GoodFlat();
  draft.rooms[4].boxes[0].x0 = 560;
  EXPECT_FALSE(Judge(draft, {}).has_value()) << "a gap between rooms";
  PlanOptions options;
  options.min_area_m2 = 100.0f;
  EXPECT_FALSE(Judge(GoodFlat(), options).has_value()) << "too small";
}

TEST(Judge, PrefersTheTargetSizes) {
  Draft other = GoodFlat();
  other.rooms[kLiving].boxes[0].y1 = other.rooms[kKitchen].boxes[0].y0 = 420;
  const auto good = Judge(GoodFlat(), {});
  const auto worse = Judge(other, {});
  ASSERT_TRUE(good.has_value() && worse.has_value());
  EXPECT_LT(good->penalty, worse->penalty);
}

}  // namespace
}  // namespace bulletnav::sim::plan
