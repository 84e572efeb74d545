// SPDX-License-Identifier: MIT
#include "sim/house/plan/doors.h"

#include <algorithm>
#include <cmath>

#include "sim/base/elementary.h"
#include "sim/house/plan/convex.h"
#include "sim/house/plan/rules.h"
#include "sim/math/pose.h"

namespace bulletnav::sim::plan {
namespace {

constexpr float kCornerMargin = 0.12f;  // between a jamb and the nearest wall face
constexpr float kApproach = 0.45f;      // metres kept free on both sides of every opening
constexpr float kLeafGap = 0.06f;       // between leaves
constexpr float kLeafWallGap = 0.05f;
constexpr float kNarrowestArch = 1.0f;

float Rad(double deg) {
  return static_cast<float>(DegToRad(deg));
}

/// A stretch of border clear of the walls that meet its ends.
struct Stretch {
  Border border;
  float from = 0.0f;
  float to = 0.0f;

  float length() const { return to - from; }
};

class DoorPlacer {
 public:
  DoorPlacer(const Layout& layout, const DoorStyle& style, Rng* rng)
      : layout_(layout), style_(style), rng_(rng), grid_(layout.draft) {}

  std::optional<std::vector<Opening>> Run(const std::vector<Link>& links) {
    for (const std::size_t i : HardestFirst(links)) {
      std::vector<Rated> choices = Choices(links[i]);
      std::stable_sort(choices.begin(), choices.end(), [](const Rated& a, const Rated& b) {
        return a.penalty < b.penalty;
      });
      const auto free = std::find_if(choices.begin(), choices.end(), [&](const Rated& c) {
        return IsFree(c.opening);
      });
      if (free == choices.end()) return std::nullopt;
      placed_.push_back(free->opening);
    }
    return std::move(placed_);
  }

 private:
  struct Rated {
    Opening opening;
    double penalty = 0.0;
  };

  const Draft& draft() const { return layout_.draft; }

  std::vector<std::size_t> HardestFirst(const std::vector<Link>& links) const {
    std::vector<std::size_t> order(links.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto wall = [&](std::size_t i) {
      return layout_.SharedWall(links[i].a, links[i].b);
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return wall(i) < wall(j);
    });
    return order;
  }

  std::vector<Rated> Choices(const Link& link) {
    std::vector<Rated> choices;
    for (const Border& border : layout_.borders) {
      if (!border.Joins(link.a, link.b)) continue;
      const Stretch stretch = ClearStretch(border);
      if (link.kind == OpeningKind::kArch) {
        AddArches(link, stretch, &choices);
      } else {
        AddDoors(link, stretch, &choices);
      }
    }
    return choices;
  }

  Stretch ClearStretch(const Border& border) const {
    return {border, 0.01f * static_cast<float>(border.from) + EndMargin(border, false),
            0.01f * static_cast<float>(border.to) - EndMargin(border, true)};
  }

  /// Outside a niche's corner the thicker outer wall comes nearer.
  float EndMargin(const Border& border, bool at_end) const {
    const bool low_is_out = border.low == kOutside;
    const bool is_outer = low_is_out || border.high == kOutside;
    const bool is_niche = is_outer && RoomBeyond(border, at_end, low_is_out) != kOutside;
    const int cm = is_niche ? draft().outer_cm - draft().wall_cm / 2 : draft().wall_cm / 2;
    return 0.01f * static_cast<float>(cm) + kCornerMargin;
  }

  /// The room past a border's end, on its low or its high side.
  int RoomBeyond(const Border& border, bool at_end, bool low_side) const {
    const int along = at_end ? border.to + 1 : border.from - 1;
    const int across = low_side ? border.at - 1 : border.at + 1;
    return border.is_vertical ? grid_.RoomAt(across, along) : grid_.RoomAt(along, across);
  }

  /// Whether a wall of `room` meets the border there, so that a leaf can stand along it.
  bool IsCornerOf(int room, const Border& border, bool at_end) const {
    return RoomBeyond(border, at_end, border.low == room) != room;
  }

  void AddArches(const Link& link, const Stretch& stretch, std::vector<Rated>* choices) {
    if (stretch.length() < kNarrowestArch) return;
    const bool to_hall = IsCirculation(draft().type(link.a)) || IsCirculation(draft().type(link.b));
    const double share = rng_->Uniform(0.45, 0.85);
    const float most = to_hall ? style_.widest_hall_arch : style_.widest_arch;
    const float width =
        std::clamp(static_cast<float>(share) * stretch.length(), kNarrowestArch, most);
    const float slack = stretch.length() - width;
    for (const double place : {0.5, 0.5, rng_->Uniform(0.1, 0.9)}) {
      const float from = stretch.from + static_cast<float>(place) * slack;
      Opening arch = MakeOpening(draft(), stretch.border, link.a, from, from + width);
      arch.room_b = link.b;
      arch.kind = OpeningKind::kArch;
      arch.top = style_.arch_top;
      const double penalty = std::abs(place - 0.5) - 0.1 * static_cast<double>(width);
      choices->push_back({arch, penalty + rng_->Uniform(0.0, 0.2)});
    }
  }

  void AddDoors(const Link& link, const Stretch& stretch, std::vector<Rated>* choices) {
    const bool is_entry_door = link.b == kOutside;
    const float width =
        static_cast<float>(is_entry_door ? rng_->Uniform(0.92, 1.0) : rng_->Uniform(0.81, 0.93));
    if (stretch.length() < 0.8f) return;
    const float clear = std::min(width, stretch.length());
    const float slack = stretch.length() - clear;
    const float gap = static_cast<float>(rng_->Uniform(0.03, 0.28));
    const float offset = std::min(gap, slack);
    AddDoorAt(link, stretch, stretch.from + offset, clear, choices);
    AddDoorAt(link, stretch, stretch.to - offset - clear, clear, choices);
    AddDoorAt(link, stretch, stretch.from + 0.5f * slack, clear, choices);
  }

  /// The room a leaf swings into: out of circulation, never into a corridor, into small rooms.
  int SwingRoom(const Link& link) const {
    if (link.b == kOutside) return link.a;
    const bool a_is_hall = IsCirculation(draft().type(link.a));
    const bool b_is_hall = IsCirculation(draft().type(link.b));
    if (a_is_hall != b_is_hall) return a_is_hall ? link.b : link.a;
    if (IsSmall(draft().type(link.a)) != IsSmall(draft().type(link.b))) {
      return IsSmall(draft().type(link.a)) ? link.a : link.b;
    }
    return draft().type(link.a) == RoomType::kCorridor ? link.b : link.a;
  }

  void AddDoorAt(const Link& link, const Stretch& stretch, float from, float width,
                 std::vector<Rated>* choices) {
    const int swing = SwingRoom(link);
    Opening door = MakeOpening(draft(), stretch.border, link.a, from, from + width);
    door.room_b = link.b;
    door.top = style_.door_top;
    door.has_leaf = true;
    door.opens_into_a = swing == link.a;
    const float to_start = from - stretch.from + kCornerMargin;
    const float to_end = stretch.to - from - width + kCornerMargin;
    const bool a_is_start = IsAtStart(door, stretch);
    for (const bool at_end : {false, true}) {
      const float gap = at_end ? to_end : to_start;
      const bool has_wall = gap < 0.45f && IsCornerOf(swing, stretch.border, at_end);
      door.hinge_at_a = at_end != a_is_start;
      const double penalty = (has_wall ? 0.0 : 1.0) + rng_->Uniform(0.0, 0.5) +
                             (gap > 0.45f && !has_wall ? 0.6 : 0.0) + NeighbourPenalty(door);
      if (link.b == kOutside) {
        const double central = static_cast<double>(std::min({to_start, to_end, 0.6f}));
        choices->push_back({door, 0.15 * ToLivingRoom(door) - central + 0.1 * penalty});
        continue;
      }
      for (const double more : {0.0, 0.3, 0.8}) {
        door.door_angle = LeafAngle(swing, has_wall ? gap : 1.0f, more > 0.0);
        choices->push_back({door, penalty + more});
      }
    }
  }

  /// Visitors come in near the living room. Metres from its nearest box.
  double ToLivingRoom(const Opening& door) const {
    double nearest = 1e9;
    for (const DraftRoom& room : draft().rooms) {
      if (room.type != RoomType::kLivingRoom) continue;
      for (const Box& box : room.boxes) {
        const double x = 100.0 * static_cast<double>(door.a.x());
        const double y = 100.0 * static_cast<double>(door.a.y());
        const double dx = std::max({0.0, box.x0 - x, x - box.x1});
        const double dy = std::max({0.0, box.y0 - y, y - box.y1});
        nearest = std::min(nearest, 0.01 * (dx + dy));
      }
    }
    return nearest;
  }

  static bool IsAtStart(const Opening& door, const Stretch& stretch) {
    return stretch.border.is_vertical ? door.a.y() < door.b.y() : door.a.x() < door.b.x();
  }

  /// Doors like company: two beside each other leave long walls free. But not too close.
  double NeighbourPenalty(const Opening& door) const {
    double penalty = 0.0;
    for (const Opening& other : placed_) {
      const double distance =
          static_cast<double>((0.5f * (door.a + door.b) - 0.5f * (other.a + other.b)).norm());
      if (distance < 1.6) penalty -= 0.15;
      const bool same_room = other.room_a == door.room_a || other.room_a == door.room_b ||
                             other.room_b == door.room_a || (other.room_b == door.room_b);
      if (same_room && distance < 1.0) penalty += 0.25;
    }
    return penalty;
  }

  /// How far a leaf stands open whose hinge is `gap` from the wall it opens against.
  float LeafAngle(int swing, float gap, bool is_second_try) {
    const RoomType type = draft().type(swing);
    const float most = std::min(
        Rad(112.0), Rad(90.0) + Asin(std::clamp((gap - kLeafWallGap) / 0.95f, 0.0f, 0.5f)));
    const Box box = draft().Bounds(swing);
    const bool is_narrow = draft().Clear(std::min(box.width(), box.height())) < 1.4f;
    if (is_narrow) return std::min(most, Rad(rng_->Uniform(86.0, 100.0)));
    if (is_second_try) return std::min(most, Rad(rng_->Uniform(84.0, 96.0)));
    if ((type == RoomType::kBathroom || type == RoomType::kStorage) && rng_->Chance(0.3)) {
      return Rad(rng_->Uniform(50.0, 70.0));
    }
    if (rng_->Chance(0.2)) return Rad(rng_->Uniform(62.0, 80.0));
    return std::min(most, Rad(rng_->Uniform(80.0, 110.0)));
  }

  bool IsFree(const Opening& opening) const {
    if (opening.has_leaf && opening.door_angle > 0.0f && !LeafFitsRoom(opening)) return false;
    return std::none_of(placed_.begin(), placed_.end(), [&](const Opening& other) {
      return Disturbs(opening, other);
    });
  }

  static bool Disturbs(const Opening& a, const Opening& b) {
    if (AreClose(ApproachZone(a, 0.0f), ApproachZone(b, 0.0f), 0.2f)) return true;
    if (a.has_leaf && AreClose(LeafOutline(a), ApproachZone(b, kApproach), 0.0f)) return true;
    if (b.has_leaf && AreClose(LeafOutline(b), ApproachZone(a, kApproach), 0.0f)) return true;
    return a.has_leaf && b.has_leaf && AreClose(LeafOutline(a), LeafOutline(b), kLeafGap);
  }

  /// The leaf's free edge must lie in the room it swings into, off its walls.
  bool LeafFitsRoom(const Opening& door) const {
    const int room = door.opens_into_a ? door.room_a : door.room_b;
    const float inset = 0.005f * static_cast<float>(draft().wall_cm) + 0.03f;
    const auto leaf = LeafOutline(door);
    return IsDeepIn(room, leaf[1], inset) && IsDeepIn(room, leaf[2], inset);
  }

  /// A square of half side `inset` around the point belongs to the room.
  bool IsDeepIn(int room, const PlanPoint& p, float inset) const {
    const auto cm = [](float metres) {
      return static_cast<int>(std::lround(100.0f * metres));
    };
    const auto is_in = [&](float dx, float dy) {
      return grid_.RoomAt(cm(p.x() + dx), cm(p.y() + dy)) == room;
    };
    return is_in(-inset, -inset) && is_in(-inset, inset) && is_in(inset, -inset) &&
           is_in(inset, inset);
  }

  const Layout& layout_;
  const DoorStyle& style_;
  Rng* rng_;
  CellGrid grid_;
  std::vector<Opening> placed_;
};

}  // namespace

Opening MakeOpening(const Draft& draft, const Border& border, int room, float from, float to) {
  const bool is_outer = border.low == kOutside || border.high == kOutside;
  const bool is_low = border.low == room;
  float at = 0.01f * static_cast<float>(border.at);
  if (is_outer) {
    const float shift = 0.005f * static_cast<float>(draft.outer_cm - draft.wall_cm);
    at += is_low ? shift : -shift;
  }
  Opening opening;
  opening.room_a = room;
  opening.wall_thickness = 0.01f * static_cast<float>(is_outer ? draft.outer_cm : draft.wall_cm);
  // Walking down a vertical border the high side is to the left; walking right, the low side is.
  if (border.is_vertical) {
    opening.a = {at, is_low ? to : from};
    opening.b = {at, is_low ? from : to};
  } else {
    opening.a = {is_low ? from : to, at};
    opening.b = {is_low ? to : from, at};
  }
  return opening;
}

std::optional<std::vector<Opening>> PlaceDoors(const Layout& layout, const std::vector<Link>& links,
                                               const DoorStyle& style, Rng* rng) {
  return DoorPlacer(layout, style, rng).Run(links);
}

}  // namespace bulletnav::sim::plan
