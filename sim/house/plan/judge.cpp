// SPDX-License-Identifier: MIT
#include "sim/house/plan/judge.h"

#include <algorithm>
#include <cmath>

#include "sim/base/elementary.h"
#include "sim/house/plan/rules.h"

namespace bulletnav::sim::plan {
namespace {

constexpr int kNarrowestNiche = 240;  // cm of outside between two parts of the house
constexpr float kArchWall = 1.25f;    // clear wall an arch or a wide doorway needs

/// Signed clear dimensions come from the outline: each edge moves inwards by half a wall.
double OutlineArea(const std::vector<GridPoint>& loop, int wall_cm) {
  double twice = 0.0;
  double perimeter = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const GridPoint& p = loop[i];
    const GridPoint& q = loop[(i + 1) % loop.size()];
    twice += static_cast<double>(p.x) * q.y - static_cast<double>(q.x) * p.y;
    perimeter += std::abs(p.x - q.x) + std::abs(p.y - q.y);
  }
  const double half = 0.5 * wall_cm;
  return 1e-4 * (0.5 * std::abs(twice) - half * perimeter + 4.0 * half * half);
}

class Inspector {
 public:
  Inspector(const Draft& draft, const PlanOptions& options)
      : options_(options), grid_(draft), layout_{draft, grid_.Borders(), 0.0} {}

  std::optional<Layout> Run() {
    if (grid_.HasOverlaps() || grid_.HasPinches() || !HasGoodFootprint()) return std::nullopt;
    for (int room = 0; room < count(); ++room) {
      if (!HasGoodShape(room) || !HasDaylight(room)) return std::nullopt;
    }
    if (!HasGoodSize() || !HasGoodNeighbours()) return std::nullopt;
    RateSizes();
    RateZones();
    RateFootprint();
    return std::move(layout_);
  }

 private:
  int count() const { return static_cast<int>(draft().rooms.size()); }
  const Draft& draft() const { return layout_.draft; }
  RoomType type(int room) const { return draft().type(room); }

  bool HasGoodFootprint() const {
    const auto outline = grid_.Outline([](int room) {
      return room != kOutside;
    });
    if (outline.empty()) return false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const GridPoint& p = outline[i];
      const GridPoint& q = outline[(i + 1) % outline.size()];
      if (std::abs(p.x - q.x) + std::abs(p.y - q.y) < 60) return false;
    }
    return !HasNiche(outline);
  }

  /// Two walls of the outline face each other across a narrow gap outside.
  static bool HasNiche(const std::vector<GridPoint>& outline) {
    struct Side {
      bool is_vertical;
      int at, from, to, sense;  // sense: +1 if the house lies towards larger coordinates
    };
    std::vector<Side> sides;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const GridPoint& p = outline[i];
      const GridPoint& q = outline[(i + 1) % outline.size()];
      if (p.x == q.x) {
        sides.push_back({true, p.x, std::min(p.y, q.y), std::max(p.y, q.y), q.y > p.y ? 1 : -1});
      } else {
        sides.push_back({false, p.y, std::min(p.x, q.x), std::max(p.x, q.x), q.x < p.x ? 1 : -1});
      }
    }
    for (const Side& a : sides) {
      for (const Side& b : sides) {
        if (a.is_vertical != b.is_vertical || a.sense > 0 || b.sense < 0) continue;
        const bool face = std::min(a.to, b.to) > std::max(a.from, b.from);
        const int gap = b.at - a.at;
        const int deep = std::min(a.to, b.to) - std::max(a.from, b.from);
        const int least = deep < 180 ? 130 : kNarrowestNiche;  // porches may be narrow
        if (face && gap > 0 && gap < least) return true;
      }
    }
    return false;
  }

  bool HasGoodShape(int room) {
    const DraftRoom& r = draft().rooms[static_cast<std::size_t>(room)];
    const RoomRule& rule = RuleOf(r.type);
    if (r.boxes.empty()) return false;
    const auto outline = grid_.Outline([&](int owner) {
      return owner == room;
    });
    if (outline.empty() || outline.size() > 8) return false;
    const auto area = static_cast<float>(OutlineArea(outline, draft().wall_cm));
    areas_.push_back(area);
    if (area < rule.min_area || area > rule.max_area) return false;
    const Box box = draft().Bounds(room);
    const float width = draft().Clear(box.width());
    const float height = draft().Clear(box.height());
    if (std::max(width, height) > rule.max_aspect * std::min(width, height)) return false;
    return IsWideEnough(r, rule, outline.size() > 4) && HasNoNeck(r);
  }

  bool IsWideEnough(const DraftRoom& room, const RoomRule& rule, bool is_bent) const {
    for (const Box& box : room.boxes) {
      const float narrow = draft().Clear(std::min(box.width(), box.height()));
      // A side arm of an L-shaped room may be narrower than a room, but not than a passage.
      const float least = is_bent && rule.min_side > 1.3f ? 1.2f : rule.min_side;
      if (narrow < least - 1e-4f) return false;
      if (room.type == RoomType::kCorridor && narrow > kMaxCorridor + 0.05f) return false;
    }
    return true;
  }

  /// The parts of a bent room open into each other widely.
  bool HasNoNeck(const DraftRoom& room) const {
    std::vector<Box> joined = {room.boxes.front()};
    std::vector<Box> left(room.boxes.begin() + 1, room.boxes.end());
    for (std::size_t i = 0; i < left.size();) {
      const bool fits = std::any_of(joined.begin(), joined.end(), [&](const Box& box) {
        return draft().Clear(SharedEdge(box, left[i])) >= kMinCorridor - 0.01f;
      });
      if (!fits) {
        ++i;
        continue;
      }
      joined.push_back(left[i]);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
    return left.empty();
  }

  static int SharedEdge(const Box& a, const Box& b) {
    const int along_x = std::min(a.x1, b.x1) - std::max(a.x0, b.x0);
    const int along_y = std::min(a.y1, b.y1) - std::max(a.y0, b.y0);
    if (along_x == 0) return std::max(0, along_y);
    return along_y == 0 ? std::max(0, along_x) : 0;
  }

  bool HasDaylight(int room) const {
    const float wanted = RuleOf(type(room)).min_window_wall;
    return wanted == 0.0f || layout_.SharedWall(room, kOutside) >= wanted;
  }

  bool HasGoodSize() const {
    float sum = 0.0f;
    float largest = 0.0f;
    float circulation = 0.0f;
    for (int room = 0; room < count(); ++room) {
      const float area = areas_[static_cast<std::size_t>(room)];
      sum += area;
      if (IsCirculation(type(room))) circulation += area;
      if (type(room) != RoomType::kLivingRoom) largest = std::max(largest, area);
    }
    return sum >= options_.min_area_m2 && sum <= options_.max_area_m2 &&
           circulation < 0.22f * sum && areas_[0] >= largest;
  }

  /// Any room of type `wanted` that shares enough wall with `room`.
  bool Adjoins(int room, RoomType wanted, float wall) const {
    for (int other = 0; other < count(); ++other) {
      if (other != room && type(other) == wanted && layout_.SharedWall(room, other) >= wall) {
        return true;
      }
    }
    return false;
  }

  bool HasGoodNeighbours() const {
    bool has_dining = false;
    for (int room = 0; room < count(); ++room) {
      if (type(room) != RoomType::kDiningRoom) continue;
      has_dining = true;
      if (!Adjoins(room, RoomType::kKitchen, kArchWall)) return false;
      if (!Adjoins(room, RoomType::kLivingRoom, kArchWall) &&
          !Adjoins(room, RoomType::kCorridor, kArchWall)) {
        return false;
      }
    }
    for (int room = 0; room < count(); ++room) {
      if (type(room) == RoomType::kKitchen && !has_dining &&
          !Adjoins(room, RoomType::kLivingRoom, kArchWall)) {
        return false;
      }
      if (type(room) == RoomType::kBathroom && GapToBedroom(room) > 250) return false;
    }
    return true;
  }

  /// Free distance between a room and the nearest bedroom, cm.
  int GapToBedroom(int room) const {
    int nearest = 100000;
    for (int other = 0; other < count(); ++other) {
      if (IsSleeping(type(other))) nearest = std::min(nearest, Gap(room, other));
    }
    return nearest;
  }

  int Gap(int a, int b) const {
    int nearest = 100000;
    for (const Box& p : draft().rooms[static_cast<std::size_t>(a)].boxes) {
      for (const Box& q : draft().rooms[static_cast<std::size_t>(b)].boxes) {
        const int dx = std::max({0, p.x0 - q.x1, q.x0 - p.x1});
        const int dy = std::max({0, p.y0 - q.y1, q.y0 - p.y1});
        nearest = std::min(nearest, dx + dy);
      }
    }
    return nearest;
  }

  void RateSizes() {
    for (int room = 0; room < count(); ++room) {
      const auto index = static_cast<std::size_t>(room);
      const DraftRoom& r = draft().rooms[index];
      if (IsCirculation(r.type)) {
        layout_.penalty += 0.06 * static_cast<double>(areas_[index]);
        continue;
      }
      const double off = Log(static_cast<double>(areas_[index] / r.target));
      const Box box = draft().Bounds(room);
      const double aspect = std::abs(Log(static_cast<double>(box.width()) / box.height()));
      layout_.penalty += 3.0 * off * off + 0.8 * std::max(0.0, aspect - 0.35);
      if (r.boxes.size() > 1) layout_.penalty += r.type == RoomType::kLivingRoom ? 0.1 : 0.4;
    }
  }

  void RateZones() {
    for (int a = 0; a < count(); ++a) {
      for (int b = 0; b < count(); ++b) {
        if (a == b) continue;
        const double metres = 0.01 * Gap(a, b);
        layout_.penalty += Pull(type(a), type(b)) * std::min(metres, 6.0);
        const bool share = metres == 0.0 && layout_.SharedWall(a, b) > 0.8f;
        if (share && a < b && IsWet(type(a)) && IsWet(type(b))) layout_.penalty -= 0.25;
      }
    }
  }

  /// Long outlines around little ground cost.
  void RateFootprint() {
    double perimeter = 0.0;
    double area = 0.0;
    for (const Border& border : layout_.borders) {
      if (border.low == kOutside || border.high == kOutside) perimeter += 0.01 * border.length();
    }
    for (const float a : areas_) area += static_cast<double>(a);
    layout_.penalty += 1.2 * (perimeter / std::sqrt(area) - 4.0);
  }

  /// How much a metre between two rooms costs.
  static double Pull(RoomType a, RoomType b) {
    if (a == RoomType::kEntry && b == RoomType::kLivingRoom) return 0.3;
    if (a == RoomType::kToilet && (b == RoomType::kEntry || b == RoomType::kLivingRoom)) return 0.1;
    if (a == RoomType::kLaundry && (b == RoomType::kKitchen || b == RoomType::kBathroom))
      return 0.1;
    if (a == RoomType::kBathroom && IsSleeping(b)) return 0.06;
    if (a == RoomType::kKitchen && b == RoomType::kLivingRoom) return 0.25;
    if (a == RoomType::kDiningRoom && b == RoomType::kLivingRoom) return 0.2;
    return 0.0;
  }

  const PlanOptions& options_;
  CellGrid grid_;
  Layout layout_;
  std::vector<float> areas_;
};

}  // namespace

float Layout::SharedWall(int a, int b) const {
  int longest = 0;
  for (const Border& border : borders) {
    if (border.Joins(a, b)) longest = std::max(longest, border.length());
  }
  return longest == 0 ? 0.0f : std::max(0.0f, draft.Clear(longest));
}

std::optional<Layout> Judge(const Draft& draft, const PlanOptions& options) {
  return Inspector(draft, options).Run();
}

float ClearArea(const Draft& draft, int room) {
  const CellGrid grid(draft);
  const auto outline = grid.Outline([&](int owner) {
    return owner == room;
  });
  return static_cast<float>(OutlineArea(outline, draft.wall_cm));
}

}  // namespace bulletnav::sim::plan
