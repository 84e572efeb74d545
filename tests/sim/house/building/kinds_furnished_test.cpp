// SPDX-License-Identifier: MIT
// What makes a clinic a clinic, a hotel a hotel and a school a school.
#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/house/building/building_plan.h"
#include "sim/house/building/decorate.h"
#include "sim/house/furnish.h"

namespace bulletnav::sim::building {
namespace {

using Names = std::initializer_list<const char*>;

struct Furnished {
  FloorPlan plan;
  std::vector<std::map<std::string, int>> pieces;  // by room
  std::vector<float> covered;                      // by room, m2 of floor under pieces
  std::vector<Furnishing> furniture;
};

Furnished Furnish(const BuildingKind& kind, std::uint64_t seed, const AreaLimits& limits) {
  const Rng rng(seed, "kinds_furnished_test");
  Furnished building;
  building.plan = GenerateBuildingPlan(kind, rng, limits);
  const HouseStyle style = DrawBuildingStyle(kind, building.plan, rng);
  MeshBuilder builder;
  building.furniture = FurnishRooms(building.plan, style, kind.furnish, rng, &builder);
  building.pieces.resize(building.plan.rooms.size());
  building.covered.resize(building.plan.rooms.size());
  for (const Furnishing& piece : building.furniture) {
    const auto room = static_cast<std::size_t>(piece.room);
    ++building.pieces[room][piece.kind];
    const Eigen::Vector3f size = piece.high - piece.low;
    if (piece.position.y() + piece.low.y() < 0.1f) building.covered[room] += size.x() * size.z();
  }
  return building;
}

/// The share of rooms of a type that hold at least `least` pieces of one of the kinds.
double ShareWith(const Furnished& building, RoomType type, Names kinds, int least = 1) {
  int rooms = 0;
  int with = 0;
  for (std::size_t i = 0; i < building.plan.rooms.size(); ++i) {
    if (building.plan.rooms[i].type != type) continue;
    ++rooms;
    int count = 0;
    for (const char* kind : kinds) {
      const auto found = building.pieces[i].find(kind);
      count += found == building.pieces[i].end() ? 0 : found->second;
    }
    with += count >= least ? 1 : 0;
  }
  return rooms == 0 ? 1.0 : static_cast<double>(with) / rooms;
}

bool HasRoom(const FloorPlan& plan, RoomType type) {
  return std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const Room& room) {
    return room.type == type;
  });
}

/// Whether a way leads from a room straight into one of a type.
bool LeadsTo(const FloorPlan& plan, int room, RoomType type) {
  return std::any_of(plan.openings.begin(), plan.openings.end(), [&](const Opening& opening) {
    if (!opening.IsPassage() || (opening.room_a != room && opening.room_b != room)) return false;
    const int other = opening.room_a == room ? opening.room_b : opening.room_a;
    return other >= 0 && plan.rooms[static_cast<std::size_t>(other)].type == type;
  });
}

/// Where a piece's middle is on the floor.
Eigen::Vector2f MiddleOf(const Furnishing& piece) {
  return {piece.position.x(), piece.position.z()};
}

TEST(KindsFurnished, DesksHaveChairs) {
  for (const BuildingKind* kind : AllKinds()) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(std::string(kind->name) + " " + std::to_string(seed));
      const Furnished building = Furnish(*kind, seed, {250.0f, 350.0f});
      for (const Furnishing& desk : building.furniture) {
        if (desk.kind != "desk") continue;
        const bool has_chair = std::any_of(
            building.furniture.begin(), building.furniture.end(), [&](const Furnishing& chair) {
              return chair.kind == "office_chair" && chair.room == desk.room &&
                     (MiddleOf(chair) - MiddleOf(desk)).norm() < 1.4f;
            });
        EXPECT_TRUE(has_chair) << "room " << desk.room;
      }
    }
  }
}

TEST(KindsFurnished, SignsHangBesideDoors) {
  int signs = 0;
  int beside = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Furnished hotel = Furnish(Hotel(), seed, {300.0f, 500.0f});
    for (const Furnishing& sign : hotel.furniture) {
      if (sign.kind != "room_sign") continue;
      ++signs;
      for (const Opening& opening : hotel.plan.openings) {
        if (!opening.IsPassage() || (opening.room_a != sign.room && opening.room_b != sign.room)) {
          continue;
        }
        const Eigen::Vector2f middle = 0.5f * (opening.a + opening.b);
        if ((middle - MiddleOf(sign)).norm() > 1.2f) continue;
        ++beside;
        break;
      }
    }
  }
  EXPECT_GT(signs, 20);
  EXPECT_GE(beside, (9 * signs) / 10);
}

/// Basins bring one.
TEST(KindsFurnished, WashroomsHaveNoMirrorAboveAMirror) {
  for (const BuildingKind* kind : {&Hotel(), &School()}) {
    const Furnished building = Furnish(*kind, 1, {250.0f, 350.0f});
    for (std::size_t i = 0; i < building.plan.rooms.size(); ++i) {
      const RoomType type = building.plan.rooms[i].type;
      if (type != RoomType::kRestroom && type != RoomType::kBathroom) continue;
      EXPECT_FALSE(building.pieces[i].contains("mirror")) << building.plan.rooms[i].name;
    }
  }
}

TEST(KindsFurnished, ClinicsTreatAndBedPatients) {
  bool has_wards = false;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    const Furnished clinic = Furnish(Clinic(), seed, {300.0f, 500.0f});
    EXPECT_GE(ShareWith(clinic, RoomType::kWard, {"hospital_bed"}), 0.9);
    EXPECT_GE(ShareWith(clinic, RoomType::kExamRoom,
                        {"exam_couch", "operating_table", "imaging_scanner"}),
              0.9);
    EXPECT_GE(ShareWith(clinic, RoomType::kWaitingRoom, {"seat_row"}, 2), 0.9);
    EXPECT_EQ(ShareWith(clinic, RoomType::kLobby, {"seat_row"}), 1.0);
    EXPECT_EQ(ShareWith(clinic, RoomType::kCorridor, {"hand_rail"}), 1.0);
    has_wards = has_wards || HasRoom(clinic.plan, RoomType::kWard);
  }
  EXPECT_TRUE(has_wards);
}

TEST(KindsFurnished, HotelRoomsHaveABedAndABathAndLookAlike) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    const Furnished hotel = Furnish(Hotel(), seed, {300.0f, 500.0f});
    EXPECT_EQ(ShareWith(hotel, RoomType::kHotelRoom, {"double_bed", "single_bed"}), 1.0);
    EXPECT_GE(ShareWith(hotel, RoomType::kBathroom, {"toilet"}), 0.8);
    std::set<float> widths;  // of all that hangs on how a bed is drawn
    int rooms = 0;
    for (std::size_t i = 0; i < hotel.plan.rooms.size(); ++i) {
      if (hotel.plan.rooms[i].type != RoomType::kHotelRoom) continue;
      ++rooms;
      EXPECT_TRUE(LeadsTo(hotel.plan, static_cast<int>(i), RoomType::kBathroom)) << i;
      EXPECT_TRUE(LeadsTo(hotel.plan, static_cast<int>(i), RoomType::kCorridor)) << i;
    }
    for (const Furnishing& piece : hotel.furniture) {
      if (piece.kind == "double_bed") widths.insert(piece.high.x() - piece.low.x());
    }
    EXPECT_GE(rooms, 3);
    EXPECT_LE(widths.size(), 1U);
  }
}

TEST(KindsFurnished, SchoolsSeatClassesBeforeBoards) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    const Furnished school = Furnish(School(), seed, {300.0f, 600.0f});
    EXPECT_TRUE(HasRoom(school.plan, RoomType::kClassroom) ||
                HasRoom(school.plan, RoomType::kLaboratory));
    EXPECT_EQ(ShareWith(school, RoomType::kClassroom, {"school_desk"}, 4), 1.0);
    EXPECT_GE(ShareWith(school, RoomType::kClassroom, {"blackboard", "whiteboard"}), 0.9);
    EXPECT_GE(ShareWith(school, RoomType::kLaboratory, {"lab_bench", "lab_wall_bench"}, 2), 0.9);
  }
}

TEST(KindsFurnished, LeaveFloorToWalkOn) {
  for (const BuildingKind* kind : {&Clinic(), &Hotel(), &School()}) {
    const Furnished building = Furnish(*kind, 9, {200.0f, 400.0f});
    for (std::size_t i = 0; i < building.covered.size(); ++i) {
      const Room& room = building.plan.rooms[i];
      EXPECT_LT(building.covered[i], 0.65f * room.area()) << kind->name << " " << room.name;
    }
  }
}

}  // namespace
}  // namespace bulletnav::sim::building
