// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "sim/house/placing/programs.h"
#include "sim/house/shell/faces.h"

namespace bulletnav::sim::placing {
namespace {

constexpr float kDepth = 0.72f;
constexpr float kCounterHeight = 0.92f;
constexpr float kBefore = 0.9f;  // free floor
constexpr float kFridgeHeight = 1.95f;
constexpr float kStep = 0.05f;
constexpr float kLongest = 4.6f;
constexpr std::array<std::string_view, 9> kClutter = {
    "kettle", "toaster", "coffee_machine", "knife_block", "cutting_board",
    "pot",    "plates",  "bowl_of_fruit",  "bottles"};

/// A stretch of wall where worktops can stand.
struct Stretch {
  const shell::Side* side = nullptr;
  float x0 = 0.0f;
  float x1 = 0.0f;
  float length() const { return x1 - x0; }
};

/// From x to x + width, from the floor up, `depth` into the room.
Box SliceAt(const shell::Side& side, float x, const Eigen::Vector3f& size) {
  const Eigen::Affine3f face = shell::FaceFrame(side.left, side.right);
  Box slice(face * Eigen::Vector3f(x, 0.0f, 0.02f));
  slice.extend(face * Eigen::Vector3f(x + size.x(), size.y(), size.z()));
  return slice;
}

bool IsUsable(const RoomSpace& space, const shell::Side& side, float x) {
  const Box counter = SliceAt(side, x, {kStep, kCounterHeight, kDepth});
  const Box floor = SliceAt(side, x, {kStep, kCounterHeight, kDepth + kBefore});
  return space.Contains(FootOf(floor)) && space.IsFree(floor) && !space.HidesOpening(counter) &&
         !space.MeetsDoorway(FootOf(counter)) && !space.MeetsClearance(FootOf(counter));
}

/// The longest stretch of a wall, or `best` if that is no shorter.
Stretch LongestOf(const RoomSpace& space, const shell::Side& side, Stretch best) {
  Stretch now{&side, 0.02f, 0.02f};
  const int slices = static_cast<int>((side.length() - 0.03f) / kStep);
  for (int i = 0; i < slices; ++i) {
    const float x = 0.02f + kStep * static_cast<float>(i);
    if (!IsUsable(space, side, x)) {
      now = {&side, x + kStep, x + kStep};
      continue;
    }
    now.x1 = x + kStep;
    if (now.length() > best.length()) best = now;
  }
  return best;
}

/// The longest stretch of any wall.
Stretch FindStretch(const RoomSpace& space) {
  Stretch best;
  for (const shell::Side& side : space.sides()) best = LongestOf(space, side, best);
  return best;
}

/// Sill of the lowest window above a part of the wall, 0 if there is none.
float SillAbove(const shell::Side& side, float x0, float x1) {
  float sill = 0.0f;
  for (const shell::Hole& hole : side.holes) {
    if (hole.bottom < 0.0f || hole.x1 + 0.1f < x0 || hole.x0 - 0.1f > x1) continue;
    sill = sill > 0.0f ? std::min(sill, hole.bottom) : hole.bottom;
  }
  return sill;
}

struct Module {
  std::string_view kind;
  float width = 0.0f;
};

/// What stands side by side in a stretch this long: first what no kitchen is without, then worktop
/// between.
std::vector<Module> PlanModules(float length, Rng* rng) {
  const bool has_dishwasher = length > 3.4f && rng->Chance(0.7);
  const float sink = length > 3.0f ? 1.2f : 0.8f;
  const float fixed = 0.64f + 0.61f + sink + (has_dishwasher ? 0.61f : 0.0f);
  const float left = std::max(0.0f, length - fixed);
  const int counters = left > 1.6f ? 2 : (left > 0.3f ? 1 : 0);
  const float width = counters > 0 ? left / static_cast<float>(counters) - 0.01f : 0.0f;
  std::vector<Module> modules = {{"refrigerator", 0.64f}};
  if (counters > 0) modules.push_back({"kitchen_counter", width});
  modules.push_back({"stove", 0.61f});
  if (counters > 1) modules.push_back({"kitchen_counter", width});
  modules.push_back({"kitchen_sink_counter", sink});
  if (has_dishwasher) modules.push_back({"dishwasher", 0.61f});
  return modules;
}

/// Puts the refrigerator, which is planned first, at the end where no window is; where there is no
/// place for it, it goes elsewhere.
void ArrangeModules(const RoomSpace& space, const Stretch& stretch, Rng* rng,
                    std::vector<Module>* modules) {
  float width = 0.0f;
  for (const Module& module : *modules) width += module.width;
  const float fridge = modules->front().width;
  const auto fits_at = [&](float x) {
    return !space.HidesOpening(SliceAt(*stretch.side, x, {fridge, kFridgeHeight, kDepth}));
  };
  const bool at_start = fits_at(stretch.x0);
  const bool at_end = fits_at(stretch.x0 + width - fridge);
  if (width > stretch.length() + 0.02f || (!at_start && !at_end)) modules->erase(modules->begin());
  if (!at_start || (at_end && rng->Chance(0.5))) std::reverse(modules->begin(), modules->end());
}

/// Where the row had no place for it: anywhere, without a hood if need be.
void AddMissing(RoomFurnisher* room, std::string_view kind, const Placed* near) {
  const std::vector<std::string_view> kinds = room->kinds();
  if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) return;
  const Wish wish{.width = 0.8f, .anchor = Anchor::kEnd, .near = near};
  if (room->AgainstWall(kind, wish) != nullptr) return;
  room->AgainstWall(kind, {.width = 0.8f, .height = 0.95f, .near = near, .squeeze = true});
}

}  // namespace

void FurnishWorktops(RoomFurnisher* room) {
  Stretch stretch = FindStretch(room->space());
  if (stretch.side == nullptr) {
    AddMissing(room, "stove", nullptr);
    AddMissing(room, "kitchen_sink_counter", nullptr);
    return;
  }
  // Into a corner, where the wall is longer than what is needed.
  const float length = std::min(stretch.length(), kLongest);
  if (stretch.length() > length && room->Chance(0.5)) stretch.x0 = stretch.x1 - length;
  const Placed* last = nullptr;
  bool has_fridge = false;
  float x = stretch.x0;
  std::vector<Module> modules = PlanModules(length, &room->rng());
  ArrangeModules(room->space(), stretch, &room->rng(), &modules);
  for (const Module& module : modules) {
    const float sill = SillAbove(*stretch.side, x, x + module.width);
    const Wish wish{.width = module.width, .height = sill > 0.0f ? sill - 0.03f : 0.0f};
    const Placed* placed = room->AtWall(*stretch.side, x + 0.5f * module.width, module.kind, wish);
    x += module.width;
    if (placed == nullptr) continue;
    last = placed;
    has_fridge |= module.kind == "refrigerator";
    if (module.kind == "kitchen_counter") room->OnTops(*placed, kClutter, 3);
  }
  AddMissing(room, "stove", last);
  AddMissing(room, "kitchen_sink_counter", last);
  if (!has_fridge && last != nullptr) {
    room->AgainstWall("refrigerator", {.anchor = Anchor::kEnd, .near = last});
  }
}

}  // namespace bulletnav::sim::placing
