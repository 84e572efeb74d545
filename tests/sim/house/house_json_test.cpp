// SPDX-License-Identifier: MIT
#include "sim/house/house_json.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "tests/sim/house/plan_samples.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

HouseDescription Sample(std::uint64_t seed = 0) {
  return {seed, "rustic", GenerateFloorPlan(Rng(seed, "plan_test"))};
}

HouseDescription ReadBack(const std::string& text) {
  const tests::TemporaryFolder folder;
  return ReadHouseJson(folder.Write("house.json", text));
}

void ExpectSameOpening(const Opening& a, const Opening& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.b, b.b);
  EXPECT_EQ(a.bottom, b.bottom);
  EXPECT_EQ(a.top, b.top);
  EXPECT_EQ(a.wall_thickness, b.wall_thickness);
  EXPECT_EQ(a.room_a, b.room_a);
  EXPECT_EQ(a.room_b, b.room_b);
  ASSERT_EQ(a.has_leaf, b.has_leaf);
  if (!a.has_leaf) return;
  EXPECT_EQ(a.door_angle, b.door_angle);
  EXPECT_EQ(a.hinge_at_a, b.hinge_at_a);
  EXPECT_EQ(a.opens_into_a, b.opens_into_a);
}

void ExpectSamePlan(const FloorPlan& a, const FloorPlan& b) {
  EXPECT_EQ(a.ceiling, b.ceiling);
  EXPECT_EQ(a.footprint, b.footprint);
  ASSERT_EQ(a.rooms.size(), b.rooms.size());
  for (std::size_t i = 0; i < a.rooms.size(); ++i) {
    EXPECT_EQ(a.rooms[i].name, b.rooms[i].name);
    EXPECT_EQ(a.rooms[i].type, b.rooms[i].type);
    EXPECT_EQ(a.rooms[i].outline, b.rooms[i].outline);
  }
  ASSERT_EQ(a.walls.size(), b.walls.size());
  for (std::size_t i = 0; i < a.walls.size(); ++i) {
    EXPECT_EQ(a.walls[i].a, b.walls[i].a);
    EXPECT_EQ(a.walls[i].b, b.walls[i].b);
    EXPECT_EQ(a.walls[i].thickness, b.walls[i].thickness);
    EXPECT_EQ(a.walls[i].is_outer, b.walls[i].is_outer);
  }
  ASSERT_EQ(a.openings.size(), b.openings.size());
  for (std::size_t i = 0; i < a.openings.size(); ++i) {
    ExpectSameOpening(a.openings[i], b.openings[i]);
  }
}

TEST(HouseJson, ReadsBackEqual) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const HouseDescription house = Sample(seed);
    const HouseDescription back = ReadBack(ToJson(house));
    EXPECT_EQ(back.seed, seed);
    EXPECT_EQ(back.style, "rustic");
    ExpectSamePlan(house.plan, back.plan);
    EXPECT_EQ(ToJson(back), ToJson(house));
  }
}

TEST(HouseJson, KeepsTheLargestSeed) {
  HouseDescription house = Sample();
  house.seed = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(ReadBack(ToJson(house)).seed, house.seed);
}

TEST(HouseJson, KeepsAnAwkwardStyle) {
  HouseDescription house = Sample();
  house.style = "\"half\\timbered\"\n\xc3\xa9";
  EXPECT_EQ(ReadBack(ToJson(house)).style, house.style);
}

TEST(HouseJson, WritesFloatsShort) {
  HouseDescription house = Sample();
  house.plan.ceiling = 2.6f;
  EXPECT_THAT(ToJson(house), HasSubstr("\"ceiling\": 2.6,"));
}

TEST(HouseJson, NamesTheDoorsOfEachRoom) {
  const HouseDescription house = Sample();
  const json written = json::parse(ToJson(house));
  for (std::size_t room = 0; room < house.plan.rooms.size(); ++room) {
    EXPECT_FALSE(written["rooms"][room]["doors"].empty());
    for (const int door : written["rooms"][room]["doors"]) {
      const Opening& opening = house.plan.openings.at(static_cast<std::size_t>(door));
      EXPECT_TRUE(opening.IsPassage());
      const int index = static_cast<int>(room);
      EXPECT_TRUE(opening.room_a == index || opening.room_b == index);
    }
  }
}

TEST(HouseJson, IgnoresFurtherKeys) {
  json written = json::parse(ToJson(Sample()));
  written["remarks"] = {1, 2, 3};
  written["rooms"][0]["mood"] = "calm";
  EXPECT_NO_THROW(ReadBack(written.dump()));
}

/// A change that makes the JSON bad. In `at` and `place`, {D} stands for the number of a door with
/// a leaf, {W} for a window's.
struct Damage {
  const char* name;
  const char* at;       // JSON pointer
  const char* value;    // JSON to put there; empty removes
  const char* place;    // in the complaint
  const char* message;  // in the complaint
};

class BadHouseJson : public testing::TestWithParam<Damage> {};

std::string DoorWithLeaf(const json& house) {
  for (std::size_t i = 0; i < house["openings"].size(); ++i) {
    if (!house["openings"][i]["leaf"].is_null()) return std::to_string(i);
  }
  return "none";
}

std::string WindowOf(const json& house) {
  for (std::size_t i = 0; i < house["openings"].size(); ++i) {
    if (house["openings"][i]["kind"] == "window") return std::to_string(i);
  }
  return "none";
}

std::string Filled(std::string text, const json& house) {
  for (const auto& [letter, number] :
       {std::pair{"{D}", DoorWithLeaf(house)}, std::pair{"{W}", WindowOf(house)}}) {
    for (auto at = text.find(letter); at != std::string::npos; at = text.find(letter)) {
      text.replace(at, 3, number);
    }
  }
  return text;
}

std::string ComplaintOf(const std::string& text) {
  try {
    ReadBack(text);
  } catch (const FileError& e) {
    return e.what();
  }
  return "no complaint";
}

TEST_P(BadHouseJson, IsRefusedWithItsPlace) {
  json house = json::parse(ToJson(Sample()));
  const json::json_pointer at(Filled(GetParam().at, house));
  const std::string place = Filled(GetParam().place, house);
  if (*GetParam().value == '\0') {
    house.at(at.parent_pointer()).erase(at.back());
  } else {
    house[at] = json::parse(GetParam().value);
  }
  EXPECT_THAT(ComplaintOf(house.dump()),
              AllOf(HasSubstr("house.json:" + place), HasSubstr(GetParam().message),
                    HasSubstr("generate the house again")));
}

INSTANTIATE_TEST_SUITE_P(
    All, BadHouseJson,
    testing::Values(
        Damage{"no_seed", "/seed", "", " ", "'seed' is missing"},
        Damage{"negative_seed", "/seed", "-1", "seed:", "expected a whole number"},
        Damage{"seed_as_text", "/seed", "\"7\"", "seed:", "expected a whole number"},
        Damage{"style_as_number", "/style", "7", "style:", "expected a text"},
        Damage{"flat_ceiling", "/ceiling", "0", "ceiling:", "is not above 0"},
        Damage{"null_ceiling", "/ceiling", "null", "ceiling:", "expected a number"},
        Damage{"wrong_total", "/area_m2", "3.0", "area_m2:", "is not the area"},
        Damage{"rooms_as_object", "/rooms", "{}", "rooms:", "expected a list"},
        Damage{"no_rooms", "/rooms", "[]", "rooms:", "got 0"},
        Damage{"room_as_number", "/rooms/1", "5", "rooms[1]:", "expected an object"},
        Damage{"no_name", "/rooms/1/name", "", "rooms[1]:", "'name' is missing"},
        Damage{"no_area", "/rooms/1/area_m2", "", "rooms[1]:", "'area_m2' is missing"},
        Damage{"wrong_area", "/rooms/1/area_m2", "1.0", "rooms[1].area_m2:", "is not the area"},
        Damage{"unknown_type", "/rooms/1/type", "\"ballroom\"",
               "rooms[1].type:", "'ballroom' is not one of: living_room, kitchen"},
        Damage{"two_corners", "/rooms/1/polygon", "[[0,0],[1,1]]", "rooms[1].polygon:", "got 2"},
        Damage{"flat_polygon", "/rooms/1/polygon", "[[0,0],[1,1],[2,2]]",
               "rooms[1].polygon:", "encloses nothing"},
        Damage{"point_of_three", "/rooms/1/polygon/2", "[1,2,3]",
               "rooms[1].polygon[2]:", "is not a pair"},
        Damage{"point_of_texts", "/rooms/1/polygon/2/0", "\"NaN\"",
               "rooms[1].polygon[2][0]:", "expected a number"},
        Damage{"huge_point", "/rooms/1/polygon/2/0", "1e38", "rooms[1]", "generate"},
        Damage{"beyond_floats", "/rooms/1/polygon/2/0", "1e39", "", "too large"},
        Damage{"door_out_of_range", "/rooms/1/doors/0", "999",
               "rooms[1].doors[0]:", "999 is none of the"},
        Damage{"half_a_door", "/rooms/1/doors/0", "0.5", "rooms[1].doors[0]:", "whole number"},
        Damage{"foreign_door", "/rooms/1/doors", "[]", "rooms[1].doors:", "are not the doors"},
        Damage{"no_openings", "/openings", "", " ", "'openings' is missing"},
        Damage{"unknown_kind", "/openings/0/kind", "\"hatch\"",
               "openings[0].kind:", "'hatch' is not one of: door, arch, window"},
        Damage{"no_width", "/openings/0", R"({"kind":"door","a":[1,1],"b":[1,1]})",
               "openings[0]:", "has no length"},
        Damage{"upside_down", "/openings/0/top", "-1", "openings[0].top:", "is not above"},
        Damage{"room_out_of_range", "/openings/0/rooms/0", "99",
               "openings[0].rooms[0]:", "99 is none of the"},
        Damage{"negative_room", "/openings/0/rooms/1", "-1",
               "openings[0].rooms[1]:", "whole number"},
        Damage{"three_rooms", "/openings/0/rooms", "[0,1,2]", "openings[0].rooms:", "pair"},
        Damage{"same_room_twice", "/openings/0/rooms", "[1,1]", "openings[0].rooms:", "twice"},
        Damage{"thin_wall", "/openings/0/wall_thickness", "-0.1",
               "openings[0].wall_thickness:", "is not above 0"},
        Damage{"leaf_without_hinge", "/openings/{D}/leaf/hinge", "",
               "openings[{D}].leaf:", "'hinge' is missing"},
        Damage{"unknown_hinge", "/openings/{D}/leaf/hinge", "\"c\"",
               "openings[{D}].leaf.hinge:", "'c' is not one of: a, b"},
        Damage{"leaf_into_nowhere", "/openings/{D}/leaf/opens_into", "99",
               "openings[{D}].leaf.opens_into:", "99 is none"},
        Damage{"leaf_in_window", "/openings/{W}/leaf", "{}",
               "openings[{W}].leaf:", "belongs to a window"},
        Damage{"no_walls", "/walls", "", " ", "'walls' is missing"},
        Damage{"outer_as_number", "/walls/0/is_outer", "1", "walls[0].is_outer:", "true or false"},
        Damage{"no_footprint", "/footprint", "[]", "footprint:", "got 0"}),
    [](const auto& test) {
      return test.param.name;
    });

TEST(HouseJson, ReadsBackKindAndFurniture) {
  HouseDescription house = Sample();
  house.kind = "office";
  house.furniture = {
      {"office_chair", 1, {-0.3f, 0, -0.3f}, {0.3f, 1, 0.25f}, {1, 0, -2}, 0.5f, "office_chair_3"}};
  const HouseDescription back = ReadBack(ToJson(house));
  EXPECT_EQ(back.kind, "office");
  ASSERT_EQ(back.furniture.size(), 1U);
  EXPECT_EQ(back.furniture[0].kind, "office_chair");
  EXPECT_EQ(back.furniture[0].room, 1);
  EXPECT_EQ(back.furniture[0].low, house.furniture[0].low);
  EXPECT_EQ(back.furniture[0].high, house.furniture[0].high);
  EXPECT_EQ(back.furniture[0].position, house.furniture[0].position);
  EXPECT_EQ(back.furniture[0].yaw, house.furniture[0].yaw);
  EXPECT_EQ(back.furniture[0].name, "office_chair_3");

  json text = json::parse(ToJson(house));
  text["furniture"][0]["room"] = 99;
  EXPECT_THAT(ComplaintOf(text.dump()), HasSubstr("furniture[0].room:"));
}

TEST(HouseJson, ReadsBackPits) {
  HouseDescription house = Sample(1);
  EXPECT_EQ(ToJson(house).find("pits"), std::string::npos);
  Pit pit;
  pit.room = 0;
  pit.into = {0.0f, 1.0f};
  pit.across = {-1.0f, 0.0f};
  pit.first_drop = 0.5f;
  pit.rails = {true, false, true, false};
  pit.rail = Rail::kGlass;
  house.plan.pits.push_back(pit);
  const HouseDescription back = ReadBack(ToJson(house));
  ASSERT_EQ(back.plan.pits.size(), 1u);
  EXPECT_EQ(back.plan.pits[0].Outline(), pit.Outline());
  EXPECT_EQ(ToJson(back), ToJson(house));
}

TEST(HouseJson, RefusesARoomNameTwice) {
  json house = json::parse(ToJson(Sample()));
  house["rooms"][1]["name"] = house["rooms"][0]["name"];
  EXPECT_THAT(ComplaintOf(house.dump()), HasSubstr("rooms[1].name:"));
}

TEST(HouseJson, SaysWhereTheSyntaxIsBad) {
  EXPECT_THAT(ComplaintOf("{\"seed\": 1,\n \"style\": NaN}"),
              AllOf(HasSubstr("house.json:2:"), HasSubstr("NaN"), HasSubstr("generate the house")));
  EXPECT_THAT(ComplaintOf(""), HasSubstr("cut off"));
  EXPECT_THAT(ComplaintOf("[]"), HasSubstr("expected an object"));
  EXPECT_THAT(ComplaintOf("null"), HasSubstr("expected an object"));
}

TEST(HouseJson, RefusesEveryCutOffFile) {
  const std::string text = ToJson(Sample());
  for (std::size_t size = 0; size + 2 < text.size(); size += 97) {
    EXPECT_THAT(ComplaintOf(text.substr(0, size)), HasSubstr("house.json:"));
  }
}

TEST(HouseJson, RefusesAMissingFile) {
  const tests::TemporaryFolder folder;
  EXPECT_THROW(ReadHouseJson(folder.path() / "none.json"), FileError);
}

}  // namespace
}  // namespace bulletnav::sim
