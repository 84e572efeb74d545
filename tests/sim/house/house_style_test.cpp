// SPDX-License-Identifier: MIT
#include "sim/house/house_style.h"

#include <algorithm>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/house/style/style_book.h"
#include "sim/house/style/tint.h"
#include "tests/sim/house/plan_samples.h"

namespace bulletnav::sim {
namespace {

using testing::HasSubstr;

constexpr int kHouses = 40;

struct House {
  FloorPlan plan;
  HouseStyle style;
};

std::vector<House> Houses() {
  std::vector<House> houses;
  for (FloorPlan& plan : SamplePlans(kHouses)) {
    HouseStyle style = DrawHouseStyle(plan, Rng(houses.size(), "style_test"));
    houses.push_back({std::move(plan), std::move(style)});
  }
  return houses;
}

bool IsHardWearing(const Surface& surface) {
  const MaterialFamily family = FindMaterial(surface.material).family;
  return family == MaterialFamily::kTile || family == MaterialFamily::kStone;
}

std::vector<Surface> SurfacesOf(const RoomStyle& room) {
  std::vector<Surface> all = {room.walls.upper, room.floor, room.ceiling, room.baseboard};
  if (room.walls.split > 0.0f) all.push_back(room.walls.lower);
  if (room.accent_edge >= 0) all.push_back(room.accent.upper);
  if (room.crown) all.push_back(*room.crown);
  if (room.beams) all.push_back(*room.beams);
  const Palette& p = room.palette;
  all.insert(all.end(), {p.wood, p.other_wood, p.metal, p.fabric, p.accent, p.bedding, p.cabinet,
                         p.counter, p.ceramic, p.rug, p.shade});
  return all;
}

TEST(DrawHouseStyle, NamesMaterialsThatExist) {
  for (const House& house : Houses()) {
    ASSERT_EQ(house.style.rooms.size(), house.plan.rooms.size());
    for (const RoomStyle& room : house.style.rooms) {
      for (const Surface& surface : SurfacesOf(room))
        EXPECT_NO_THROW(FindMaterial(surface.material));
    }
    for (const Surface& surface :
         {house.style.door, house.style.entry_door, house.style.door_frame, house.style.handle,
          house.style.threshold, house.style.window_frame, house.style.window_sill,
          house.style.views[0], house.style.views[1], house.style.views[2], house.style.views[3]}) {
      EXPECT_NO_THROW(FindMaterial(surface.material));
    }
  }
}

TEST(DrawHouseStyle, FitsSurfacesToRoomTypes) {
  for (const House& house : Houses()) {
    std::set<std::string_view> living_floors;
    for (std::size_t i = 0; i < house.plan.rooms.size(); ++i) {
      const RoomStyle& room = house.style.rooms[i];
      const RoomType type = house.plan.rooms[i].type;
      if (type == RoomType::kBathroom || type == RoomType::kToilet) {
        EXPECT_TRUE(IsHardWearing(room.floor)) << room.floor.material;
        EXPECT_TRUE(IsHardWearing(room.walls.lower)) << room.walls.lower.material;
        EXPECT_GE(room.walls.split, 1.2f);
      }
      if (type == RoomType::kLivingRoom || type == RoomType::kDiningRoom ||
          type == RoomType::kCorridor) {
        living_floors.insert(room.floor.material);
      }
      EXPECT_LT(room.accent_edge, static_cast<int>(house.plan.rooms[i].outline.size()));
    }
    EXPECT_EQ(living_floors.size(), 1u);
  }
}

/// Largest minus smallest channel.
int Chroma(const Rgb8& c) {
  return *std::max_element(c.begin(), c.end()) - *std::min_element(c.begin(), c.end());
}

TEST(DrawHouseStyle, PaintsKidsRoomsInColor) {
  for (const House& house : Houses()) {
    for (std::size_t i = 0; i < house.plan.rooms.size(); ++i) {
      if (house.plan.rooms[i].type != RoomType::kKidsRoom) continue;
      const RoomStyle& room = house.style.rooms[i];
      const Rgb8& main = room.walls.split > 0.0f ? room.walls.lower.tint : room.walls.upper.tint;
      EXPECT_GE(Chroma(main), 35);
      EXPECT_GE(Chroma(room.palette.bedding.tint), 60);
    }
  }
}

TEST(DrawHouseStyle, LetsNoTwoRoomsLookAlike) {
  for (const House& house : Houses()) {
    for (std::size_t i = 0; i < house.plan.rooms.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool same_type = house.plan.rooms[i].type == house.plan.rooms[j].type;
        EXPECT_GE(Difference(house.style.rooms[i], house.style.rooms[j]), same_type ? 15.0 : 9.0)
            << house.plan.rooms[i].name << " and " << house.plan.rooms[j].name << " in style "
            << static_cast<int>(house.style.kind);
      }
    }
  }
}

TEST(DrawHouseStyle, KnowsAllStylesAndRepeatsItself) {
  std::set<StyleKind> kinds;
  for (const House& house : Houses()) kinds.insert(house.style.kind);
  EXPECT_EQ(kinds.size(), EnumNames<StyleKind>::kNames.size());
  const FloorPlan plan = GenerateFloorPlan(Rng(3, "plan_test"));
  const HouseStyle a = DrawHouseStyle(plan, Rng(5, "x"));
  const HouseStyle b = DrawHouseStyle(plan, Rng(5, "x"));
  EXPECT_EQ(a.kind, b.kind);
  for (std::size_t i = 0; i < a.rooms.size(); ++i) {
    EXPECT_EQ(Difference(a.rooms[i], b.rooms[i]), 0.0);
  }
}

TEST(Difference, CountsColorsAndMaterials) {
  RoomStyle room;
  room.walls.upper = {"plaster_smooth", style::Hex(0xF0E0D0)};
  room.floor = {"oak_planks"};
  for (Surface* s :
       {&room.palette.wood, &room.palette.fabric, &room.palette.accent, &room.palette.rug}) {
    *s = {"linen"};
  }
  RoomStyle other = room;
  EXPECT_EQ(Difference(room, other), 0.0);
  other.floor = {"grey_large_tile"};
  const double floor_only = Difference(room, other);
  EXPECT_GT(floor_only, 5.0);
  other.walls.upper.tint = style::Hex(0x405870);
  EXPECT_GT(Difference(room, other), floor_only + 20.0);
}

std::string WhyNot(const std::string& key, const std::string& value) {
  std::string text;
  std::istringstream lines(ReadTextFile(BULLETNAV_STYLES "/modern.yaml"));
  for (std::string line; std::getline(lines, line);) {
    text += (line.starts_with(key + ":") ? key + ": " + value : line) + "\n";
  }
  try {
    style::ReadBook(text, "book.yaml");
  } catch (const FileError& e) {
    return e.what();
  }
  return "taken";
}

TEST(ReadBook, SaysWhereABookIsWrong) {
  EXPECT_EQ(WhyNot("accents", "[0xE0B04F]"), "taken");
  EXPECT_THAT(WhyNot("accents", "[0xE0B04]"), HasSubstr(": '0xE0B04' is no colour"));
  EXPECT_THAT(WhyNot("accents", "[]"), HasSubstr("'accents' has no entry"));
  EXPECT_THAT(WhyNot("metals", "[black_mettle]"), HasSubstr("black_metal"));
  EXPECT_THAT(WhyNot("metals", "[{black_metal: 0xFFFFFF, copper: 0xFFFFFF}]"),
              HasSubstr("a surface is a material or {material: colour}"));
  EXPECT_THAT(WhyNot("upholstery", "[lining]"), HasSubstr("book.yaml:"));
  EXPECT_THAT(WhyNot("metals", "black"), HasSubstr("book.yaml:"));
}

TEST(BookOf, HasAFullBookForEveryStyle) {
  for (const auto& [name, kind] : EnumNames<StyleKind>::kNames) {
    const style::StyleBook& book = style::BookOf(kind);
    EXPECT_GE(book.neutrals.size(), 4u) << name;
    EXPECT_GE(book.colors.size(), 6u) << name;
    EXPECT_GE(book.bath_tiles.size(), 4u) << name;
    for (const auto* list :
         {&book.features, &book.panels, &book.main_floors, &book.bedroom_floors,
          &book.kitchen_floors, &book.bath_floors, &book.bath_tiles, &book.ceilings, &book.doors,
          &book.frames, &book.window_frames, &book.woods, &book.metals, &book.cabinets,
          &book.counters, &book.rugs}) {
      EXPECT_FALSE(list->empty()) << name;
      for (const Surface& s : *list) EXPECT_NO_THROW(FindMaterial(s.material)) << name;
    }
    for (const auto* list : {&book.wallpapers, &book.upholstery}) {
      EXPECT_FALSE(list->empty()) << name;
      for (const std::string_view s : *list) EXPECT_NO_THROW(FindMaterial(s)) << name;
    }
  }
}

}  // namespace
}  // namespace bulletnav::sim
