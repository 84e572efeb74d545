// SPDX-License-Identifier: MIT
#include "sim/house/plan/strip.h"

#include <gtest/gtest.h>

namespace bulletnav::sim::plan {
namespace {

constexpr Axes kNorthOfCorridor{{100, 50}, {1, 0}, {0, -1}};

Draft Bedrooms() {
  Draft draft;
  draft.rooms = {{RoomType::kBedroom, 12.0f, {}},
                 {RoomType::kBathroom, 5.0f, {}},
                 {RoomType::kStorage, 3.0f, {}},
                 {RoomType::kKidsRoom, 11.0f, {}},
                 {RoomType::kToilet, 1.8f, {}}};
  return draft;
}

int AreaOf(const Draft& draft) {
  int area = 0;
  for (const DraftRoom& room : draft.rooms) {
    for (const Box& box : room.boxes) area += box.width() * box.height();
  }
  return area;
}

TEST(StripSpan, IsEmptyWhereARoomCannotBe) {
  const Draft draft = Bedrooms();
  EXPECT_TRUE(SlotSpan(draft, {.room = 0}, 200).empty());  // not deep enough for a bed
  EXPECT_TRUE(SlotSpan(draft, {.room = 4}, 500).empty());  // a toilet five metres long
  EXPECT_FALSE(SlotSpan(draft, {.room = 0}, 400).empty());
}

TEST(StripSpan, WantsTheTargetArea) {
  const Draft draft = Bedrooms();
  const Span span = SlotSpan(draft, {.room = 0}, 412);
  EXPECT_NEAR(draft.Clear(span.want) * draft.Clear(412), 12.0f, 0.3f);
}

TEST(FillStrip, FillsItsStretchExactly) {
  const Strip strip{430, {{.room = 0}, {.room = 1, .behind = 2}, {.room = 3, .notch = 4}}};
  const Span span = StripSpan(Bedrooms(), strip);
  ASSERT_FALSE(span.empty());
  for (int length = span.low; length <= span.high; length += 3 * kGrid) {
    Draft draft = Bedrooms();
    Rng rng(static_cast<std::uint64_t>(length), "strip");
    FillStrip(strip, kNorthOfCorridor, length, &draft, &rng);
    EXPECT_EQ(AreaOf(draft), length * 430);
    const CellGrid grid(draft);
    EXPECT_FALSE(grid.HasOverlaps());
    EXPECT_EQ(grid.Outline([](int room) {
                    return room != kOutside;
                  })
                  .size(),
              4u);
    EXPECT_EQ(draft.Bounds(0).x0, 100);
    EXPECT_EQ(draft.Bounds(3).x1, 100 + length);
    EXPECT_EQ(draft.Bounds(1).y1, 50);        // at the corridor
    EXPECT_EQ(draft.Bounds(2).y0, 50 - 430);  // at the outside wall
  }
}

TEST(FillStrip, LeavesAPorchBeforeTheEntry) {
  Draft draft;
  draft.rooms = {{RoomType::kEntry, 4.5f, {}}};
  const Strip strip{400, {{.room = 0, .porch_cm = 120}}};
  Rng rng(1, "porch");
  FillStrip(strip, kNorthOfCorridor, StripSpan(draft, strip).want, &draft, &rng);
  EXPECT_EQ(draft.Bounds(0).height(), 280);
}

}  // namespace
}  // namespace bulletnav::sim::plan
