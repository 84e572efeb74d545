// SPDX-License-Identifier: MIT
#include "sim/house/house_style.h"

#include <algorithm>

#include "sim/house/style/decorator.h"
#include "sim/house/style/style_book.h"

namespace bulletnav::sim {
namespace {

using style::HouseTheme;
using style::StyleBook;

constexpr int kTries = 80;                // ways to decorate a room that are compared
constexpr double kUnlikeSameType = 20.0;  // wanted Difference
constexpr double kUnlike = 13.0;

/// How far a room is from being mistaken for one before it: at least 1 is good.
double Margin(const FloorPlan& plan, const std::vector<RoomStyle>& before, const RoomStyle& room) {
  double margin = 1e9;
  const RoomType type = plan.rooms[before.size()].type;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double wanted = plan.rooms[i].type == type ? kUnlikeSameType : kUnlike;
    margin = std::min(margin, Difference(before[i], room) / wanted);
  }
  return margin;
}

RoomStyle DrawRoom(const StyleBook& book, const HouseTheme& theme, const FloorPlan& plan,
                   const std::vector<RoomStyle>& before, Rng* rng) {
  const int room = static_cast<int>(before.size());
  RoomStyle best = style::DecorateRoom(book, theme, plan, room, rng);
  double margin = Margin(plan, before, best);
  for (int i = 0; i < kTries && margin < 1.0; ++i) {
    const RoomStyle other = style::DecorateRoom(book, theme, plan, room, rng);
    const double other_margin = Margin(plan, before, other);
    if (other_margin <= margin) continue;
    best = other;
    margin = other_margin;
  }
  return best;
}

/// Flats look at the city; houses have a garden behind and the street before the door.
std::array<Surface, 4> DrawViews(Rng* rng) {
  if (rng->Chance(0.3)) {
    const Surface street{rng->Chance(0.5) ? "street_view" : "city_view"};
    return {Surface{"city_view"}, street, Surface{"city_view"}, street};
  }
  std::array<Surface, 4> views = {Surface{"garden_view"}, Surface{"street_view"},
                                  Surface{"garden_view"}, Surface{"hills_view"}};
  rng->Shuffle(views);
  return views;
}

/// Most doors between different floors have a threshold, few others do.
std::vector<float> DrawThresholds(const FloorPlan& plan, const std::vector<RoomStyle>& rooms,
                                  Rng* rng) {
  std::vector<float> heights;
  for (const Opening& opening : plan.openings) {
    heights.push_back(0.0f);
    if (opening.kind != OpeningKind::kDoor || opening.room_b < 0) continue;
    const Surface& a = rooms[static_cast<std::size_t>(opening.room_a)].floor;
    const Surface& b = rooms[static_cast<std::size_t>(opening.room_b)].floor;
    const bool differs = a.material != b.material || a.tint != b.tint;
    if (rng->Chance(differs ? 0.7 : 0.1)) {
      heights.back() = static_cast<float>(rng->Uniform(0.005, 0.02));
    }
  }
  return heights;
}

}  // namespace

HouseStyle DrawHouseStyle(const FloorPlan& plan, const Rng& rng) {
  Rng draw = rng.Fork("style");
  HouseStyle house;
  house.kind =
      static_cast<StyleKind>(draw.Below(static_cast<int>(EnumNames<StyleKind>::kNames.size())));
  const StyleBook& book = style::BookOf(house.kind);
  const HouseTheme theme = style::DrawTheme(book, &draw);
  house.door = draw.Pick(book.doors);
  house.entry_door = draw.Pick(book.doors);
  house.door_frame = theme.frame;
  house.handle = draw.Pick(book.metals);
  house.threshold = draw.Chance(0.5) ? theme.wood : Surface{"brass"};
  house.window_frame = draw.Pick(book.window_frames);
  house.window_sill = draw.Chance(0.5) ? theme.frame : Surface{"limestone"};
  house.has_panelled_doors = book.has_panelled_doors;
  house.has_cased_arches = book.has_panelled_doors || draw.Chance(0.4);
  house.has_glazing_bars = book.has_panelled_doors && draw.Chance(0.6);
  house.views = DrawViews(&draw);
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    house.rooms.push_back(DrawRoom(book, theme, plan, house.rooms, &draw));
  }
  house.thresholds = DrawThresholds(plan, house.rooms, &draw);
  return house;
}

}  // namespace bulletnav::sim
