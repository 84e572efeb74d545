// SPDX-License-Identifier: MIT
#include "sim/house/plan/windows.h"

#include <algorithm>
#include <cmath>

#include "sim/base/check.h"
#include "sim/house/plan/convex.h"
#include "sim/house/plan/doors.h"
#include "sim/house/plan/rules.h"

namespace bulletnav::sim::plan {
namespace {

struct WindowRule {
  RoomType type = RoomType::kLivingRoom;
  float min_width = 0.8f;
  float max_width = 1.6f;
  float sill = 0.9f;
  float height = 0.0f;       // 0: from the sill to the head
  double first_wall = 1.0;   // chance of a window in the longest outside wall
  double other_walls = 0.3;  // and in each other one
  float corner = 0.45f;      // least distance to a corner
};

using enum RoomType;
constexpr std::array kWindowRules = {
    WindowRule{kLivingRoom, 1.4f, 2.6f, 0.65f, 0.0f, 1.0, 0.6, 0.5f},
    WindowRule{kKitchen, 0.9f, 1.6f, 1.05f, 0.0f, 1.0, 0.2, 0.4f},
    WindowRule{kDiningRoom, 1.2f, 2.0f, 0.75f, 0.0f, 1.0, 0.5, 0.5f},
    WindowRule{kBedroom, 1.1f, 1.8f, 0.9f, 0.0f, 1.0, 0.3, 0.45f},
    WindowRule{kKidsRoom, 1.0f, 1.6f, 0.9f, 0.0f, 1.0, 0.25, 0.45f},
    WindowRule{kBathroom, 0.5f, 0.9f, 1.4f, 0.6f, 0.9, 0.0, 0.3f},
    WindowRule{kToilet, 0.4f, 0.5f, 1.5f, 0.5f, 0.8, 0.0, 0.2f},
    WindowRule{kCorridor, 0.6f, 1.0f, 0.9f, 0.0f, 0.8, 0.6, 0.25f},
    WindowRule{kEntry, 0.4f, 0.7f, 0.9f, 0.0f, 0.4, 0.3, 0.3f},
    WindowRule{kStudy, 1.0f, 1.6f, 0.85f, 0.0f, 1.0, 0.3, 0.45f},
    WindowRule{kLaundry, 0.5f, 0.9f, 1.3f, 0.6f, 0.8, 0.0, 0.3f},
    WindowRule{kStorage, 0.4f, 0.5f, 1.6f, 0.45f, 0.25, 0.0, 0.25f},
    WindowRule{kOpenOffice, 1.5f, 3.0f, 0.8f, 0.0f, 1.0, 0.8, 0.3f},
    WindowRule{kOffice, 1.2f, 2.4f, 0.8f, 0.0f, 1.0, 0.3, 0.3f},
    WindowRule{kMeetingRoom, 1.5f, 2.8f, 0.6f, 0.0f, 0.9, 0.3, 0.3f},
    WindowRule{kReception, 1.6f, 3.0f, 0.45f, 0.0f, 1.0, 0.5, 0.3f},
    WindowRule{kBreakRoom, 1.2f, 2.4f, 0.9f, 0.0f, 0.9, 0.3, 0.4f},
    WindowRule{kRestroom, 0.5f, 1.0f, 1.5f, 0.5f, 0.6, 0.0, 0.3f},
    WindowRule{kStockRoom, 0.6f, 1.2f, 1.6f, 0.5f, 0.4, 0.0, 0.3f},
    WindowRule{kTechnicalRoom, 0.5f, 0.8f, 1.6f, 0.5f, 0.2, 0.0, 0.3f},
    WindowRule{kWard, 1.6f, 2.8f, 0.8f, 0.0f, 1.0, 0.2, 0.4f},
    WindowRule{kExamRoom, 1.0f, 1.8f, 1.0f, 0.0f, 0.9, 0.2, 0.4f},
    WindowRule{kWaitingRoom, 1.4f, 2.6f, 0.7f, 0.0f, 1.0, 0.5, 0.4f},
    WindowRule{kShopFloor, 2.0f, 3.0f, 0.5f, 0.0f, 0.9, 0.2, 0.4f},
    WindowRule{kFittingRoom, 0.4f, 0.5f, 1.6f, 0.4f, 0.0, 0.0, 0.3f},
    WindowRule{kClassroom, 1.5f, 2.8f, 0.85f, 0.0f, 1.0, 0.1, 0.5f},
    WindowRule{kLaboratory, 1.4f, 2.6f, 1.0f, 0.0f, 1.0, 0.2, 0.5f},
    WindowRule{kCanteen, 1.6f, 3.0f, 0.5f, 0.0f, 1.0, 0.7, 0.4f},
    WindowRule{kHotelRoom, 1.2f, 2.2f, 0.7f, 0.0f, 1.0, 0.2, 0.4f},
    WindowRule{kLobby, 1.6f, 3.0f, 0.45f, 0.0f, 1.0, 0.7, 0.4f},
    WindowRule{kWorkshop, 1.6f, 2.8f, 1.2f, 0.0f, 0.9, 0.5, 0.5f},
    WindowRule{kWarehouse, 1.4f, 2.4f, 1.2f, 0.8f, 0.7, 0.4, 0.8f},
    WindowRule{kAssemblyHall, 1.6f, 2.8f, 1.3f, 0.0f, 1.0, 0.5, 0.6f},
    WindowRule{kPaintRoom, 0.8f, 1.6f, 1.4f, 0.6f, 0.5, 0.1, 0.4f},
    WindowRule{kStairwell, 0.8f, 1.6f, 1.1f, 0.0f, 0.7, 0.3, 0.4f},
    WindowRule{kStudio, 1.6f, 3.0f, 0.6f, 0.0f, 1.0, 0.8, 0.4f},
};

const WindowRule& WindowRuleOf(RoomType type) {
  const auto& rule = kWindowRules[static_cast<std::size_t>(type)];
  BULLETNAV_CHECK(rule.type == type);
  return rule;
}

constexpr float kMostGlass = 0.22f;  // of the floor; no further wall gets windows beyond that

enum class Side { kWest, kEast, kNorth, kSouth };

class WindowPlacer {
 public:
  WindowPlacer(const Layout& layout, const std::vector<Opening>& doors, const WindowStyle& style,
               Rng* rng)
      : layout_(layout), doors_(doors), style_(style), rng_(rng) {}

  std::vector<Opening> Run() {
    if (style_.is_flat) ChooseBlindSides();
    bool has_terrace = !rng_->Chance(style_.terrace_chance);
    for (int room = 0; room < static_cast<int>(layout_.draft.rooms.size()); ++room) {
      const WindowRule& rule = WindowRuleOf(layout_.draft.type(room));
      bool is_first = true;
      for (const Border& border : OuterWalls(room)) {
        const double chance = is_first ? rule.first_wall : rule.other_walls;
        if (GlassIn(room) > kMostGlass * ClearArea(layout_.draft, room)) break;
        if (!rng_->Chance(chance)) continue;
        const bool may_be_terrace = rule.type == kLivingRoom || rule.type == kDiningRoom;
        const bool is_terrace = may_be_terrace && !has_terrace && AddTerraceDoor(room, border);
        if (is_terrace) has_terrace = true;
        if (!is_terrace && !AddRow(room, border, rule, 0) && !AddRow(room, border, rule, 1))
          continue;
        is_first = false;
      }
    }
    return std::move(windows_);
  }

 private:
  static Side SideOf(const Border& border) {
    if (border.is_vertical) return border.low == kOutside ? Side::kWest : Side::kEast;
    return border.low == kOutside ? Side::kNorth : Side::kSouth;
  }

  float GlassIn(int room) const {
    float sum = 0.0f;
    for (const Opening& window : windows_) {
      if (window.room_a == room) sum += window.width() * (window.top - window.bottom);
    }
    return sum;
  }

  bool IsBlind(const Border& border) const {
    return blind_[static_cast<std::size_t>(SideOf(border))];
  }

  /// Outside walls of a room that may have windows, the longest first.
  std::vector<Border> OuterWalls(int room) const {
    std::vector<Border> walls;
    for (const Border& border : layout_.borders) {
      if (border.Joins(room, kOutside) && !IsBlind(border)) walls.push_back(border);
    }
    std::stable_sort(walls.begin(), walls.end(), [](const Border& a, const Border& b) {
      return a.length() > b.length();
    });
    return walls;
  }

  void ChooseBlindSides() {
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    rng_->Shuffle(order);
    int blind = rng_->Between(1, 2);
    for (const std::size_t side : order) {
      blind_[side] = true;
      if (blind == 0 || !IsEveryRoomLit()) {
        blind_[side] = false;
      } else {
        --blind;
      }
    }
  }

  bool IsEveryRoomLit() const {
    for (int room = 0; room < static_cast<int>(layout_.draft.rooms.size()); ++room) {
      const float wanted = RuleOf(layout_.draft.type(room)).min_window_wall;
      const auto walls = OuterWalls(room);
      const float longest = walls.empty() ? 0.0f : layout_.draft.Clear(walls.front().length());
      if (wanted > 0.0f && longest < wanted + 0.4f) return false;
    }
    return true;
  }

  float Start(const Border& border) const {
    return 0.01f *
           (static_cast<float>(border.from) + 0.5f * static_cast<float>(layout_.draft.wall_cm));
  }

  bool AddTerraceDoor(int room, const Border& border) {
    const float length = layout_.draft.Clear(border.length());
    if (length < 2.8f) return false;
    const float width = std::min(static_cast<float>(rng_->Uniform(1.6, 2.4)), length - 1.0f);
    const float from = Start(border) + 0.5f * (length - width);
    return TryAdd(room, border, from, width, {0.0f, style_.head});
  }

  struct Heights {
    float bottom = 0.0f;
    float top = 0.0f;
  };

  /// Evenly spaced windows, as many as suit the wall and `more`.
  bool AddRow(int room, const Border& border, const WindowRule& rule, int more) {
    const float length = layout_.draft.Clear(border.length());
    const float room_for = length - 2.0f * rule.corner;
    if (room_for < rule.min_width) return false;
    const bool is_row = length > 4.6f && rule.max_width > 1.3f;
    const int count = more + (is_row ? static_cast<int>(length / 3.0f) : 1);
    const float share = length / static_cast<float>(count);
    const float wanted = style_.scale * static_cast<float>(rng_->Uniform(0.38, 0.55)) * share;
    const float most = std::min(rule.max_width, share - 2.0f * rule.corner);
    if (most < rule.min_width) return false;
    const float width = std::clamp(wanted, rule.min_width, most);
    const float sill = std::max(0.45f, rule.sill - style_.low_sill);
    const float bottom = rule.height > 0.0f ? style_.head - rule.height : sill;
    bool added = false;
    for (int i = 0; i < count; ++i) {
      const float centre = Start(border) + (static_cast<float>(i) + 0.5f) * share;
      if (TryAdd(room, border, centre - 0.5f * width, width, {bottom, style_.head})) added = true;
    }
    return added;
  }

  bool TryAdd(int room, const Border& border, float from, float width, const Heights& heights) {
    Opening window = MakeOpening(layout_.draft, border, room, from, from + width);
    window.kind = OpeningKind::kWindow;
    window.bottom = heights.bottom;
    window.top = heights.top;
    const bool is_free = std::none_of(doors_.begin(), doors_.end(), [&](const Opening& door) {
      return AreClose(ApproachZone(window, 0.0f), ApproachZone(door, 0.0f), 0.3f);
    });
    if (is_free) windows_.push_back(window);
    return is_free;
  }

  const Layout& layout_;
  const std::vector<Opening>& doors_;
  const WindowStyle& style_;
  Rng* rng_;
  std::array<bool, 4> blind_{};
  std::vector<Opening> windows_;
};

}  // namespace

std::vector<Opening> PlaceWindows(const Layout& layout, const std::vector<Opening>& doors,
                                  const WindowStyle& style, Rng* rng) {
  return WindowPlacer(layout, doors, style, rng).Run();
}

}  // namespace bulletnav::sim::plan
