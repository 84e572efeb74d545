// SPDX-License-Identifier: MIT
#include "sim/house/building/decorate.h"

#include <algorithm>
#include <array>
#include <map>

#include "sim/house/style/palettes.h"
#include "sim/house/style/style_book.h"
#include "sim/house/style/tint.h"

namespace bulletnav::sim::building {
namespace {

constexpr float kWholeWall = 9.0f;  // metres: higher than any ceiling

enum class Use { kWet, kHeavy, kSoft, kPlain };

Use UseOf(RoomType type) {
  using enum RoomType;
  constexpr std::array kWet = {kRestroom, kBathroom, kToilet, kLaundry};
  constexpr std::array kHeavy = {kStockRoom,  kTechnicalRoom, kStorage,
                                 kLaboratory, kPaintRoom,     kStairwell};
  constexpr std::array kSoft = {kHotelRoom, kMeetingRoom, kOffice, kFittingRoom};
  if (std::find(kWet.begin(), kWet.end(), type) != kWet.end()) return Use::kWet;
  if (std::find(kHeavy.begin(), kHeavy.end(), type) != kHeavy.end()) return Use::kHeavy;
  if (std::find(kSoft.begin(), kSoft.end(), type) != kSoft.end()) return Use::kSoft;
  return Use::kPlain;
}

class Decorator {
 public:
  Decorator(const Looks& looks, StyleKind book, Rng* rng)
      : looks_(looks), book_(style::BookOf(book)), rng_(rng) {
    floor_ = rng_->Pick(looks_.floors);
    wall_ = rng_->Pick(looks_.walls);
    ceiling_ = rng_->Pick(looks_.ceilings);
    tiles_ = rng_->Pick(book_.bath_tiles);
    baseboard_ = rng_->Pick(book_.frames);
  }

  /// What rooms of a type have in common.
  RoomStyle Draw(RoomType type) {
    RoomStyle style;
    style.floor = Floor(type);
    style.ceiling = ceiling_;
    style.baseboard = baseboard_;
    style.baseboard_height = UseOf(type) == Use::kPlain && rng_->Chance(0.3)
                                 ? 0.0f
                                 : 0.01f * static_cast<float>(rng_->Between(5, 10));
    style.walls.upper = Repainted(wall_);
    if (UseOf(type) == Use::kWet) {
      style.walls.lower = tiles_;
      style.walls.split =
          rng_->Chance(0.4) ? kWholeWall : static_cast<float>(rng_->Uniform(1.2, 2.0));
      style.baseboard_height = 0.0f;
    } else if (rng_->Chance(0.5 * looks_.accent_chance)) {
      style.walls.lower = rng_->Pick(looks_.accents);
      style.walls.split = static_cast<float>(rng_->Uniform(0.9, 1.4));
      style.walls.has_cap = rng_->Chance(0.5);
    }
    style.palette = style::DrawPalette(book_, type, rng_);
    return style;
  }

  /// One room in particular.
  RoomStyle Vary(RoomStyle style, std::size_t sides) {
    if (style.walls.split == 0.0f && rng_->Chance(looks_.accent_chance)) {
      style.accent_edge = rng_->Below(static_cast<int>(sides));
      style.accent = {rng_->Pick(looks_.accents), {}, 0.0f, false};
    }
    if (rng_->Chance(0.25)) style.walls.upper = Repainted(style.walls.upper);
    return style;
  }

 private:
  Surface Floor(RoomType type) {
    switch (UseOf(type)) {
      case Use::kWet:
        return rng_->Chance(0.5) ? rng_->Pick(looks_.hard_floors) : rng_->Pick(book_.bath_floors);
      case Use::kHeavy:
        return rng_->Pick(looks_.hard_floors);
      case Use::kSoft:
        return rng_->Chance(0.6) ? rng_->Pick(looks_.soft_floors) : floor_;
      case Use::kPlain:
        break;
    }
    return rng_->Chance(0.85) ? floor_ : rng_->Pick(looks_.floors);
  }

  Surface Repainted(const Surface& wall) {
    const Surface& other = rng_->Pick(looks_.walls);
    return {wall.material, style::Mix(wall.tint, other.tint, rng_->Uniform(0.0, 0.5))};
  }

  const Looks& looks_;
  const style::StyleBook& book_;
  Rng* rng_;
  Surface floor_;
  Surface wall_;
  Surface ceiling_;
  Surface tiles_;
  Surface baseboard_;
};

std::array<Surface, 4> DrawViews(Rng* rng) {
  std::array<Surface, 4> views = {Surface{"city_view"}, Surface{"street_view"},
                                  Surface{"city_view"}, Surface{"garden_view"}};
  rng->Shuffle(views);
  return views;
}

}  // namespace

HouseStyle DrawBuildingStyle(const BuildingKind& kind, const FloorPlan& plan, const Rng& rng) {
  Rng draw = rng.Fork("style");
  HouseStyle house;
  house.kind = draw.Pick(kind.looks.books);
  const style::StyleBook& book = style::BookOf(house.kind);
  house.door = draw.Pick(book.doors);
  house.entry_door = draw.Pick(book.doors);
  house.door_frame = draw.Pick(book.frames);
  house.handle = draw.Pick(book.metals);
  house.threshold = Surface{"brushed_steel"};
  house.window_frame = draw.Pick(book.window_frames);
  house.window_sill = draw.Pick(book.frames);
  house.has_panelled_doors = false;
  house.has_cased_arches = draw.Chance(0.3);
  house.views = DrawViews(&draw);
  house.thresholds.assign(plan.openings.size(), 0.0f);
  Decorator decorator(kind.looks, house.kind, &draw);
  std::map<RoomType, RoomStyle> of_type;
  for (const Room& room : plan.rooms) {
    auto found = of_type.find(room.type);
    if (found == of_type.end()) found = of_type.emplace(room.type, decorator.Draw(room.type)).first;
    house.rooms.push_back(decorator.Vary(found->second, room.outline.size()));
  }
  return house;
}

}  // namespace bulletnav::sim::building
