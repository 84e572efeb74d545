// SPDX-License-Identifier: MIT
#include "sim/house/floor_plan_generator.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/sim/house/plan_samples.h"

namespace bulletnav::sim {
namespace {

constexpr int kSeeds = 150;

struct Rect {
  float x0, y0, x1, y1;
};

Rect Bounds(const std::vector<PlanPoint>& outline) {
  Rect r{1e9f, 1e9f, -1e9f, -1e9f};
  for (const PlanPoint& p : outline) {
    r = {std::min(r.x0, p.x()), std::min(r.y0, p.y()), std::max(r.x1, p.x()),
         std::max(r.y1, p.y())};
  }
  return r;
}

/// The wall with its ends lengthened to close corners.
Rect Footprint(const Wall& wall) {
  const float half = 0.5f * wall.thickness;
  Rect r = Bounds({wall.a, wall.b});
  return {r.x0 - half, r.y0 - half, r.x1 + half, r.y1 + half};
}

int Count(const FloorPlan& plan, RoomType type) {
  return static_cast<int>(
      std::count_if(plan.rooms.begin(), plan.rooms.end(), [&](const Room& room) {
        return room.type == type;
      }));
}

RoomType TypeOf(const FloorPlan& plan, int room) {
  return plan.rooms[static_cast<std::size_t>(room)].type;
}

bool IsHall(RoomType type) {
  return type == RoomType::kCorridor || type == RoomType::kEntry;
}
bool IsSleeping(RoomType type) {
  return type == RoomType::kBedroom || type == RoomType::kKidsRoom;
}

/// Types of the rooms behind the doors and arches of one room.
std::vector<RoomType> JoinedTo(const FloorPlan& plan, int room) {
  std::vector<RoomType> types;
  for (const Opening& o : plan.openings) {
    if (!o.IsPassage() || o.room_b < 0) continue;
    if (o.room_a == room) types.push_back(TypeOf(plan, o.room_b));
    if (o.room_b == room) types.push_back(TypeOf(plan, o.room_a));
  }
  return types;
}

/// Whether two rooms have walls that face each other across one inner wall, `least` metres long.
bool ShareWall(const FloorPlan& plan, const Room& a, const Room& b, float least) {
  for (std::size_t i = 0; i < a.outline.size(); ++i) {
    for (std::size_t j = 0; j < b.outline.size(); ++j) {
      const Rect p = Bounds({a.outline[i], a.outline[(i + 1) % a.outline.size()]});
      const Rect q = Bounds({b.outline[j], b.outline[(j + 1) % b.outline.size()]});
      const float along_x = std::min(p.x1, q.x1) - std::max(p.x0, q.x0);
      const float along_y = std::min(p.y1, q.y1) - std::max(p.y0, q.y0);
      const float thickness = plan.walls.back().thickness + 0.01f;
      if (along_x >= least && along_y > -thickness && along_y <= 0.0f) return true;
      if (along_y >= least && along_x > -thickness && along_x <= 0.0f) return true;
    }
  }
  return false;
}

/// On how many points of a raster over the footprint's bounding box `f` holds.
template <class F>
int CountRaster(const FloorPlan& plan, const F& f) {
  const Rect box = Bounds(plan.footprint);
  int count = 0;
  for (float x = box.x0 - 0.213f; x < box.x1 + 0.3f; x += 0.0731f) {
    for (float y = box.y0 - 0.217f; y < box.y1 + 0.3f; y += 0.0737f) {
      if (f(PlanPoint(x, y))) ++count;
    }
  }
  return count;
}

TEST(GenerateFloorPlan, KeepsCountsAndAreasInRange) {
  for (const FloorPlan& plan : SamplePlans(kSeeds)) {
    EXPECT_GE(plan.rooms.size(), 5u);
    EXPECT_LE(plan.rooms.size(), 12u);
    EXPECT_GE(plan.area(), 60.0f);
    EXPECT_LE(plan.area(), 200.0f);
    EXPECT_GE(plan.ceiling, 2.4f);
    EXPECT_LE(plan.ceiling, 3.0f);
    EXPECT_EQ(Count(plan, RoomType::kLivingRoom), 1);
    EXPECT_EQ(Count(plan, RoomType::kKitchen), 1);
    EXPECT_GE(Count(plan, RoomType::kBathroom), 1);
    EXPECT_GE(Count(plan, RoomType::kBedroom), 1);
    EXPECT_GE(Count(plan, RoomType::kCorridor) + Count(plan, RoomType::kEntry), 1);
    std::set<std::string> names;
    for (const Room& room : plan.rooms) names.insert(room.name);
    EXPECT_EQ(names.size(), plan.rooms.size());
  }
}

TEST(GenerateFloorPlan, GivesRoomsDecentSizes) {
  const std::map<RoomType, std::pair<float, float>> limits = {
      {RoomType::kLivingRoom, {14, 48}}, {RoomType::kKitchen, {6, 20}},
      {RoomType::kDiningRoom, {8, 22}},  {RoomType::kBedroom, {8, 24}},
      {RoomType::kKidsRoom, {8, 18}},    {RoomType::kBathroom, {3.5f, 9}},
      {RoomType::kToilet, {1.5f, 3}},    {RoomType::kCorridor, {1.5f, 30}},
      {RoomType::kEntry, {2.5f, 12}},    {RoomType::kStudy, {6, 16}},
      {RoomType::kLaundry, {3, 9}},      {RoomType::kStorage, {1.5f, 7}}};
  for (const FloorPlan& plan : SamplePlans(kSeeds)) {
    for (const Room& room : plan.rooms) {
      const auto& [least, most] = limits.at(room.type);
      EXPECT_GE(room.area(), least) << room.name;
      EXPECT_LE(room.area(), most) << room.name;
      const Rect box = Bounds(room.outline);
      const float narrow = std::min(box.x1 - box.x0, box.y1 - box.y0);
      const bool is_corridor = room.type == RoomType::kCorridor;
      EXPECT_GE(narrow, IsSleeping(room.type) ? 2.49f : (is_corridor ? 1.09f : 0.94f)) << room.name;
      EXPECT_FALSE(is_corridor && room.outline.size() == 4 && narrow > 1.86f);
    }
  }
}

TEST(GenerateFloorPlan, OutlinesAreRectilinearAndWalkedWithTheRoomToTheLeft) {
  for (const FloorPlan& plan : SamplePlans(kSeeds)) {
    for (const Room& room : plan.rooms) {
      const std::size_t n = room.outline.size();
      for (std::size_t i = 0; i < n; ++i) {
        const PlanPoint step = room.outline[(i + 1) % n] - room.outline[i];
        EXPECT_GT(step.norm(), 0.05f);
        EXPECT_LT(std::min(std::abs(step.x()), std::abs(step.y())), 1e-4f);
        const PlanPoint middle = 0.5f * (room.outline[(i + 1) % n] + room.outline[i]);
        EXPECT_TRUE(IsInside(room.outline, middle + 0.02f * LeftOf(step.normalized())));
        EXPECT_FALSE(IsInside(room.outline, middle - 0.02f * LeftOf(step.normalized())));
      }
    }
  }
}

TEST(GenerateFloorPlan, RoomsAndWallsTileTheFootprint) {
  for (const FloorPlan& plan : SamplePlans(25)) {
    std::vector<Rect> walls;
    for (const Wall& wall : plan.walls) walls.push_back(Footprint(wall));
    const int wrong = CountRaster(plan, [&](const PlanPoint& p) {
      const auto rooms = std::count_if(plan.rooms.begin(), plan.rooms.end(), [&](const Room& r) {
        return IsInside(r.outline, p);
      });
      const bool in_wall = std::any_of(walls.begin(), walls.end(), [&](const Rect& r) {
        return p.x() > r.x0 && p.x() < r.x1 && p.y() > r.y0 && p.y() < r.y1;
      });
      const auto owners = rooms + (in_wall ? 1 : 0);
      return owners != (IsInside(plan.footprint, p) ? 1 : 0);
    });
    EXPECT_EQ(wrong, 0);
  }
}

void ExpectGoodPlace(const FloorPlan& plan, int index) {
  const Room& room = plan.rooms[static_cast<std::size_t>(index)];
  const std::vector<RoomType> joined = JoinedTo(plan, index);
  const auto halls = std::count_if(joined.begin(), joined.end(), IsHall);
  const auto beds = std::count_if(joined.begin(), joined.end(), IsSleeping);
  const auto adjoins = [&](RoomType type) {
    return std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const Room& other) {
      return other.type == type && ShareWall(plan, room, other, 1.2f);
    });
  };
  switch (room.type) {
    case RoomType::kBedroom:
    case RoomType::kKidsRoom:
      EXPECT_EQ(halls, 1) << room.name;
      EXPECT_EQ(beds, 0) << room.name;
      break;
    case RoomType::kKitchen:
      EXPECT_TRUE(adjoins(RoomType::kDiningRoom) || adjoins(RoomType::kLivingRoom));
      break;
    case RoomType::kDiningRoom:
      EXPECT_TRUE(adjoins(RoomType::kKitchen));
      break;
    case RoomType::kBathroom:
      EXPECT_EQ(joined.size(), 1u) << room.name;
      EXPECT_EQ(halls + beds, 1) << room.name;
      break;
    case RoomType::kToilet:
      EXPECT_EQ(halls, 1) << room.name;
      break;
    case RoomType::kStorage:
    case RoomType::kLaundry:
      EXPECT_EQ(joined.size(), 1u) << room.name;
      EXPECT_EQ(beds, 0) << room.name;
      break;
    case RoomType::kLivingRoom:
    case RoomType::kCorridor:
    case RoomType::kEntry:
    case RoomType::kStudy:
      EXPECT_GE(joined.size(), 1u) << room.name;
      break;
    default:
      ADD_FAILURE() << room.name << " is in no home";
  }
}

TEST(GenerateFloorPlan, PlacesRoomsAsInRealHomes) {
  for (const FloorPlan& plan : SamplePlans(kSeeds)) {
    bool has_shared_bathroom = false;
    for (int i = 0; i < static_cast<int>(plan.rooms.size()); ++i) {
      ExpectGoodPlace(plan, i);
      const std::vector<RoomType> joined = JoinedTo(plan, i);
      has_shared_bathroom |= TypeOf(plan, i) == RoomType::kBathroom &&
                             std::any_of(joined.begin(), joined.end(), IsHall);
    }
    EXPECT_TRUE(has_shared_bathroom);
  }
}

TEST(GenerateFloorPlan, HabitableRoomsHaveWindows) {
  for (const FloorPlan& plan : SamplePlans(kSeeds)) {
    std::map<int, float> glass;
    for (const Opening& o : plan.openings) {
      if (o.kind == OpeningKind::kWindow) glass[o.room_a] += o.width() * (o.top - o.bottom);
    }
    for (int i = 0; i < static_cast<int>(plan.rooms.size()); ++i) {
      const Room& room = plan.rooms[static_cast<std::size_t>(i)];
      const bool is_habitable = IsSleeping(room.type) || room.type == RoomType::kLivingRoom ||
                                room.type == RoomType::kDiningRoom ||
                                room.type == RoomType::kKitchen || room.type == RoomType::kStudy;
      EXPECT_TRUE(!is_habitable || glass[i] > 0.04f * room.area()) << room.name;
      EXPECT_LT(glass[i], 0.45f * room.area()) << room.name;
    }
  }
}

TEST(GenerateFloorPlan, DrawsTheSameFromTheSameSeed) {
  const FloorPlan a = GenerateFloorPlan(Rng(7, "x"));
  const FloorPlan b = GenerateFloorPlan(Rng(7, "x"));
  ASSERT_EQ(a.openings.size(), b.openings.size());
  ASSERT_EQ(a.rooms.size(), b.rooms.size());
  for (std::size_t i = 0; i < a.rooms.size(); ++i)
    EXPECT_EQ(a.rooms[i].outline, b.rooms[i].outline);
  for (std::size_t i = 0; i < a.openings.size(); ++i) {
    EXPECT_EQ(a.openings[i].a, b.openings[i].a);
    EXPECT_EQ(a.openings[i].door_angle, b.openings[i].door_angle);
  }
}

TEST(GenerateFloorPlan, DrawsDifferentHouses) {
  std::set<std::vector<RoomType>> programs;
  std::set<std::size_t> footprints;
  std::set<std::size_t> counts;
  std::set<int> areas;
  for (const FloorPlan& plan : SamplePlans(100)) {
    std::vector<RoomType> types;
    for (const Room& room : plan.rooms) types.push_back(room.type);
    std::sort(types.begin(), types.end());
    programs.insert(types);
    counts.insert(plan.rooms.size());
    footprints.insert(plan.footprint.size());
    areas.insert(static_cast<int>(10.0f * plan.area()));
  }
  EXPECT_GT(programs.size(), 60u);
  EXPECT_EQ(counts.size(), 8u);
  EXPECT_GE(footprints.size(), 4u);  // 4, 6, 8, ... corners
  EXPECT_GT(areas.size(), 90u);
}

TEST(GenerateFloorPlan, KeepsToTheOptions) {
  PlanOptions options;
  options.min_rooms = 7;
  options.max_rooms = 8;
  options.min_area_m2 = 80.0f;
  options.max_area_m2 = 110.0f;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const FloorPlan plan = GenerateFloorPlan(Rng(seed, "options"), options);
    EXPECT_GE(plan.rooms.size(), 7u);
    EXPECT_LE(plan.rooms.size(), 8u);
    EXPECT_GE(plan.area(), 80.0f);
    EXPECT_LE(plan.area(), 110.0f);
  }
}

TEST(PlanOptions, RefusesWhatCannotBeMet) {
  for (const auto& [rooms_low, rooms_high, area_low, area_high] :
       std::vector<std::tuple<int, int, float, float>>{{4, 8, 60, 200},
                                                       {9, 8, 60, 200},
                                                       {5, 13, 60, 200},
                                                       {5, 12, 50, 200},
                                                       {5, 12, 150, 160}}) {
    const PlanOptions options{rooms_low, rooms_high, area_low, area_high};
    EXPECT_THROW(options.Validate(), Error);
  }
}

}  // namespace
}  // namespace bulletnav::sim
