// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <deque>

#include <gtest/gtest.h>

#include "sim/house/plan/convex.h"
#include "sim/math/pose.h"
#include "tests/sim/house/plan_samples.h"

namespace bulletnav::sim {
namespace {

constexpr int kSeeds = 150;

float ToSegment(const PlanPoint& p, const PlanPoint& a, const PlanPoint& b) {
  const float t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0f, 1.0f);
  return (p - a - t * (b - a)).norm();
}

const Room& RoomOf(const FloorPlan& plan, int room) {
  return plan.rooms[static_cast<std::size_t>(room)];
}

/// Least distance from the opening's jambs to the ends of the wall face it lies in; negative if the
/// room has no such face.
float MarginToCorners(const Opening& o, const Room& room, float side) {
  const PlanPoint along = (o.b - o.a).normalized();
  const PlanPoint to_face = side * 0.5f * o.wall_thickness * LeftOf(along);
  for (std::size_t i = 0; i < room.outline.size(); ++i) {
    const PlanPoint& p = room.outline[i];
    const PlanPoint& q = room.outline[(i + 1) % room.outline.size()];
    const float off = std::max(ToSegment(o.a + to_face, p, q), ToSegment(o.b + to_face, p, q));
    if (off > 1e-3f || std::abs((q - p).normalized().dot(along)) < 0.9f) continue;
    float margin = 1e9f;
    for (const PlanPoint& jamb : {o.a, o.b}) {
      for (const PlanPoint& corner : {p, q}) {
        margin = std::min(margin, (jamb + to_face - corner).norm());
      }
    }
    return margin;
  }
  return -1.0f;
}

TEST(Openings, LieInAWallOfTheRoomsTheyName) {
  for (const FloorPlan& plan : SamplePlans(kSeeds)) {
    for (const Opening& o : plan.openings) {
      EXPECT_GE(MarginToCorners(o, RoomOf(plan, o.room_a), 1.0f), 0.1f);
      if (o.room_b >= 0) {
        EXPECT_GE(MarginToCorners(o, RoomOf(plan, o.room_b), -1.0f), 0.1f);
      } else {
        const PlanPoint out = -LeftOf((o.b - o.a).normalized());
        const PlanPoint step = 0.5f * (o.a + o.b) + (0.5f * o.wall_thickness + 0.02f) * out;
        EXPECT_FALSE(IsInside(plan.footprint, step));
      }
      const bool in_wall = std::any_of(plan.walls.begin(), plan.walls.end(), [&](const Wall& w) {
        return w.is_outer == (o.room_b < 0) && ToSegment(o.a, w.a, w.b) < 1e-3f &&
               ToSegment(o.b, w.a, w.b) < 1e-3f && std::abs(w.thickness - o.wall_thickness) < 1e-4f;
      });
      EXPECT_TRUE(in_wall);
    }
  }
}

TEST(Openings, HaveUsualSizes) {
  for (const FloorPlan& plan : SamplePlans(kSeeds)) {
    int entry_doors = 0;
    for (const Opening& o : plan.openings) {
      EXPECT_LT(o.bottom, o.top - 0.4f);
      EXPECT_LT(o.top, plan.ceiling - 0.1f);
      switch (o.kind) {
        case OpeningKind::kDoor:
          EXPECT_GE(o.width(), 0.79f);
          EXPECT_LE(o.width(), 1.01f);
          EXPECT_EQ(o.bottom, 0.0f);
          if (o.room_b < 0) ++entry_doors;
          EXPECT_EQ(o.door_angle == 0.0f, o.room_b < 0);
          EXPECT_TRUE(o.room_b < 0 || o.door_angle > DegToRad(44.0));
          EXPECT_LE(o.door_angle, DegToRad(115.0));
          break;
        case OpeningKind::kArch:
          EXPECT_GE(o.width(), 0.99f);
          EXPECT_LE(o.width(), 2.41f);
          EXPECT_FALSE(o.has_leaf);
          EXPECT_GE(o.room_b, 0);
          break;
        case OpeningKind::kWindow:
          EXPECT_GE(o.width(), 0.39f);
          EXPECT_LE(o.width(), 2.61f);
          EXPECT_EQ(o.room_b, -1);
          break;
      }
    }
    EXPECT_EQ(entry_doors, 1);
  }
}

TEST(Openings, DoNotOverlap) {
  for (const FloorPlan& plan : SamplePlans(kSeeds)) {
    for (std::size_t i = 0; i < plan.openings.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_FALSE(plan::AreClose(plan::ApproachZone(plan.openings[i], 0.0f),
                                    plan::ApproachZone(plan.openings[j], 0.0f), 0.1f));
      }
    }
  }
}

TEST(DoorLeaves, StayClearOfEachOtherAndOfOtherDoorways) {
  for (const FloorPlan& plan : SamplePlans(kSeeds)) {
    for (const Opening& door : plan.openings) {
      if (!door.has_leaf) continue;
      const auto leaf = LeafOutline(door);
      const Room& room = RoomOf(plan, door.opens_into_a ? door.room_a : door.room_b);
      if (door.door_angle > 0.0f) {
        EXPECT_TRUE(IsInside(room.outline, leaf[1])) << room.name;
        EXPECT_TRUE(IsInside(room.outline, leaf[2])) << room.name;
      }
      for (const Opening& other : plan.openings) {
        if (&other == &door || !other.IsPassage()) continue;
        EXPECT_FALSE(plan::AreClose(leaf, plan::ApproachZone(other, 0.4f), 0.0f)) << room.name;
        EXPECT_FALSE(other.has_leaf && plan::AreClose(leaf, LeafOutline(other), 0.04f));
      }
    }
  }
}

/// Where a round body can stand: free of walls and leaves, on a fine grid.
class BodyGrid {
 public:
  BodyGrid(const FloorPlan& plan, float radius) : plan_(plan) {
    for (const PlanPoint& p : plan.footprint) {
      low_ = low_.cwiseMin(p);
      high_ = high_.cwiseMax(p);
    }
    columns_ = static_cast<int>((high_.x() - low_.x()) / kStep) + 1;
    rows_ = static_cast<int>((high_.y() - low_.y()) / kStep) + 1;
    free_.assign(static_cast<std::size_t>(columns_ * rows_), true);
    for (const auto& wall : plan.walls) BlockWall(wall, radius);
    for (const Opening& o : plan.openings) {
      if (o.has_leaf) Block(LeafOutline(o), radius);
    }
  }

  /// The part of each room's free cells that can be reached from somewhere in room `from`.
  std::vector<float> Reach(int from) const {
    std::vector<bool> seen(free_.size(), false);
    std::deque<int> queue = {FreeCellIn(from)};
    while (!queue.empty()) {
      const int cell = queue.front();
      queue.pop_front();
      if (cell < 0 || seen[static_cast<std::size_t>(cell)]) continue;
      seen[static_cast<std::size_t>(cell)] = true;
      const int x = cell % columns_;
      const int y = cell / columns_;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const int nx = x + dx;
        const int ny = y + dy;
        if (nx < 0 || ny < 0 || nx >= columns_ || ny >= rows_) continue;
        const int next = ny * columns_ + nx;
        if (free_[static_cast<std::size_t>(next)]) queue.push_back(next);
      }
    }
    std::vector<float> parts;
    for (const Room& room : plan_.rooms) {
      float count = 0.0f;
      float reached = 0.0f;
      for (int cell = 0; cell < columns_ * rows_; ++cell) {
        if (!free_[static_cast<std::size_t>(cell)] || !IsInside(room.outline, At(cell))) continue;
        count += 1.0f;
        if (seen[static_cast<std::size_t>(cell)]) reached += 1.0f;
      }
      parts.push_back(reached / std::max(1.0f, count));
    }
    return parts;
  }

 private:
  static constexpr float kStep = 0.04f;

  PlanPoint At(int cell) const {
    return low_ + kStep * PlanPoint(static_cast<float>(cell % columns_),
                                    static_cast<float>(cell / columns_));
  }

  int FreeCellIn(int room) const {
    const auto& outline = RoomOf(plan_, room).outline;
    for (int cell = 0; cell < columns_ * rows_; ++cell) {
      if (free_[static_cast<std::size_t>(cell)] && IsInside(outline, At(cell))) return cell;
    }
    return -1;
  }

  /// The wall without the doors and arches in it.
  void BlockWall(const Wall& wall, float radius) {
    const PlanPoint along = (wall.b - wall.a).normalized();
    const PlanPoint half = 0.5f * wall.thickness * LeftOf(along);
    std::vector<std::pair<float, float>> holes;
    for (const Opening& o : plan_.openings) {
      const bool is_mine = o.IsPassage() && o.room_b >= 0 &&
                           ToSegment(o.a, wall.a, wall.b) < 1e-3f &&
                           ToSegment(o.b, wall.a, wall.b) < 1e-3f;
      const float s = (o.a - wall.a).dot(along);
      const float t = (o.b - wall.a).dot(along);
      if (is_mine) holes.emplace_back(std::min(s, t), std::max(s, t));
    }
    std::sort(holes.begin(), holes.end());
    float from = -0.5f * wall.thickness;
    holes.emplace_back((wall.b - wall.a).norm() + 0.5f * wall.thickness, 0.0f);
    for (const auto& [s, t] : holes) {
      const PlanPoint p = wall.a + from * along;
      const PlanPoint q = wall.a + s * along;
      Block({p + half, q + half, q - half, p - half}, radius);
      from = t;
    }
  }

  void Block(const plan::Quad& quad, float radius) {
    PlanPoint low = quad[0];
    PlanPoint high = quad[0];
    for (const PlanPoint& p : quad) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const auto index = [](float v) {
      return static_cast<int>(std::floor(v / kStep));
    };
    for (int y = std::max(0, index(low.y() - radius - low_.y()));
         y <= std::min(rows_ - 1, index(high.y() + radius - low_.y()) + 1); ++y) {
      for (int x = std::max(0, index(low.x() - radius - low_.x()));
           x <= std::min(columns_ - 1, index(high.x() + radius - low_.x()) + 1); ++x) {
        const int cell = y * columns_ + x;
        if (Distance(quad, At(cell)) < radius) free_[static_cast<std::size_t>(cell)] = false;
      }
    }
  }

  static float Distance(const plan::Quad& quad, const PlanPoint& p) {
    if (IsInside(quad, p)) return 0.0f;
    float nearest = 1e9f;
    for (std::size_t i = 0; i < 4; ++i) {
      nearest = std::min(nearest, ToSegment(p, quad[i], quad[(i + 1) % 4]));
    }
    return nearest;
  }

  const FloorPlan& plan_;
  PlanPoint low_{1e9f, 1e9f};
  PlanPoint high_{-1e9f, -1e9f};
  int columns_ = 0;
  int rows_ = 0;
  std::vector<bool> free_;
};

TEST(FloorPlan, EveryRoomIsReachableByABody) {
  constexpr float kRadius = 0.18f + 0.05f;  // some slack for the simulator's own grid
  for (const FloorPlan& plan : SamplePlans(40)) {
    const auto entry = std::find_if(plan.openings.begin(), plan.openings.end(), [](const auto& o) {
      return o.kind == OpeningKind::kDoor && o.room_b < 0;
    });
    ASSERT_NE(entry, plan.openings.end());
    const std::vector<float> parts = BodyGrid(plan, kRadius).Reach(entry->room_a);
    for (std::size_t i = 0; i < parts.size(); ++i) EXPECT_GT(parts[i], 0.85f) << plan.rooms[i].name;
  }
}

}  // namespace
}  // namespace bulletnav::sim
