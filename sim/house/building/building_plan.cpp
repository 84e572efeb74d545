// SPDX-License-Identifier: MIT
#include "sim/house/building/building_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/house/building/stairwell.h"
#include "sim/house/plan/assemble.h"
#include "sim/house/plan/doors.h"
#include "sim/house/plan/passage.h"
#include "sim/house/plan/windows.h"

namespace bulletnav::sim::building {
namespace {

constexpr int kRounds = 400;
constexpr float kBodyRadius = 0.24f;  // the agent's 0.18 m and slack
constexpr float kLeastSide = 0.95f;   // of a room's bounding box, metres

AreaLimits Granted(const BuildingKind& kind, AreaLimits limits) {
  if (limits.min_m2 == 0.0f) limits.min_m2 = kind.min_area_m2;
  if (limits.max_m2 == 0.0f) limits.max_m2 = kind.max_area_m2;
  const bool is_within = limits.min_m2 >= kind.min_area_m2 && limits.max_m2 <= kind.max_area_m2;
  if (!is_within || !(limits.max_m2 >= 1.2f * limits.min_m2)) {
    throw Error(fmt::format(
        "{} m2 to {} m2 is no range for buildings of kind '{}'; it must lie within {} to {}, the "
        "upper limit at least 1.2 times the lower",
        limits.min_m2, limits.max_m2, kind.name, kind.min_area_m2, kind.max_area_m2));
  }
  return limits;
}

/// Evenly in the logarithm: as many small buildings as large ones.
float DrawArea(const AreaLimits& limits, Rng* rng) {
  const double ratio = static_cast<double>(limits.max_m2) / static_cast<double>(limits.min_m2);
  const double share = rng->Uniform(0.05, 0.95);
  return static_cast<float>(static_cast<double>(limits.min_m2) * Pow(ratio, share));
}

/// A way in: through the head or a hall, whatever has the longest wall to the outside.
bool JoinToOutside(Sketch* sketch, const std::vector<plan::Border>& borders) {
  int best = -1;
  int longest = 0;
  for (const plan::Border& border : borders) {
    const bool is_outer = border.low == plan::kOutside || border.high == plan::kOutside;
    if (!is_outer) continue;
    const int room = std::max(border.low, border.high);
    const RoomType type = sketch->draft.type(room);
    const bool is_main = type == RoomType::kLobby || type == RoomType::kReception;
    const bool is_hall = type == RoomType::kCorridor || type == RoomType::kShopFloor ||
                         type == RoomType::kOpenOffice || type == RoomType::kWarehouse ||
                         type == RoomType::kWorkshop || type == RoomType::kStudio;
    const int rated = border.length() * (is_main ? 100 : (is_hall ? 1 : 0));
    if (rated <= longest || sketch->draft.Clear(border.length()) < 1.3f) continue;
    longest = rated;
    best = room;
  }
  if (best >= 0) sketch->Join(best, plan::kOutside, OpeningKind::kDoor);
  return best >= 0;
}

bool HasGoodRooms(const plan::Draft& draft, const plan::CellGrid& grid) {
  if (grid.HasOverlaps() || grid.HasPinches()) return false;
  for (int room = 0; room < static_cast<int>(draft.rooms.size()); ++room) {
    const plan::Box box = draft.Bounds(room);
    if (draft.Clear(std::min(box.width(), box.height())) < kLeastSide) return false;
    const auto outline = grid.Outline([&](int owner) {
      return owner == room;
    });
    if (outline.empty()) return false;
  }
  return true;
}

float DrawCeiling(const Heights& heights, Rng* rng) {
  return 0.05f * static_cast<float>(std::lround(20.0 * rng->Uniform(heights.low, heights.high)));
}

std::optional<FloorPlan> Draw(const BuildingKind& kind, const AreaLimits& limits, Rng* rng) {
  Sketch sketch;
  sketch.draft.wall_cm = rng->Chance(0.5) ? 10 : 14;
  sketch.draft.outer_cm = rng->Chance(0.5) ? 26 : 34;
  kind.lay(DrawArea(limits, rng), &sketch, rng);
  const plan::CellGrid grid(sketch.draft);
  if (!HasGoodRooms(sketch.draft, grid)) return std::nullopt;
  if (!JoinToOutside(&sketch, grid.Borders())) return std::nullopt;
  const plan::Layout layout{sketch.draft, grid.Borders(), 0.0};

  const float ceiling = DrawCeiling(kind.ceiling, rng);
  plan::DoorStyle doors;
  doors.arch_top = std::min(ceiling - 0.25f, static_cast<float>(rng->Uniform(2.2, 2.6)));
  doors.widest_arch = 4.0f;
  doors.widest_hall_arch = 4.0f;
  auto openings = plan::PlaceDoors(layout, sketch.links, doors, rng);
  if (!openings) return std::nullopt;
  plan::WindowStyle windows;
  windows.head = std::min(ceiling - 0.3f, static_cast<float>(rng->Uniform(2.2, 2.9)));
  windows.scale = static_cast<float>(rng->Uniform(0.9, 1.6));
  windows.terrace_chance = 1.0;
  const auto glass = plan::PlaceWindows(layout, *openings, windows, rng);
  openings->insert(openings->end(), glass.begin(), glass.end());

  FloorPlan plan = plan::Assemble(layout, *std::move(openings));
  const float area = plan.area();
  if (area < limits.min_m2 || area > limits.max_m2) return std::nullopt;
  plan.ceiling = ceiling;
  DigPits(kind.pits, rng->Fork("pits"), &plan);
  if (!plan::IsPassable(plan, kBodyRadius)) return std::nullopt;
  plan::Turn(rng->Below(8), &plan);
  return plan;
}

}  // namespace

void CheckLimits(const BuildingKind& kind, const AreaLimits& limits) {
  Granted(kind, limits);
}

FloorPlan GenerateBuildingPlan(const BuildingKind& kind, const Rng& rng, AreaLimits limits) {
  limits = Granted(kind, limits);
  for (int round = 0; round < kRounds; ++round) {
    Rng draw = rng.Fork("plan", static_cast<std::uint64_t>(round));
    std::optional<FloorPlan> plan = Draw(kind, limits, &draw);
    if (plan) return *std::move(plan);
  }
  throw Error(fmt::format("no floor plan of kind '{}' has {} m2 to {} m2", kind.name, limits.min_m2,
                          limits.max_m2));
}

}  // namespace bulletnav::sim::building
