// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "sim/house/shell/faces.h"
#include "sim/house/shell/room_shell.h"
#include "sim/math/pose.h"

namespace bulletnav::sim::shell {
namespace {

constexpr float kSeam = 0.001f;  // floors of neighbours overlap by this under the wall between them
constexpr float kBeamWidth = 0.12f;
constexpr float kBeamDepth = 0.14f;
constexpr float kBeamSpacing = 1.15f;

float InnerThickness(const FloorPlan& plan) {
  const auto inner = std::find_if(plan.walls.begin(), plan.walls.end(), [](const Wall& wall) {
    return !wall.is_outer;
  });
  return inner == plan.walls.end() ? 0.1f : inner->thickness;
}

/// The outline moved outwards by `by` on every side.
std::vector<PlanPoint> Grown(const std::vector<PlanPoint>& outline, float by) {
  std::vector<PlanPoint> grown;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const PlanPoint before = (outline[i] - outline[(i + n - 1) % n]).normalized();
    const PlanPoint after = (outline[(i + 1) % n] - outline[i]).normalized();
    grown.push_back(outline[i] - by * (LeftOf(before) + LeftOf(after)));
  }
  return grown;
}

struct Extent {
  PlanPoint low;
  PlanPoint high;
};

Extent ExtentOf(const std::vector<PlanPoint>& points) {
  Extent extent{points.front(), points.front()};
  for (const PlanPoint& p : points) {
    extent.low = extent.low.cwiseMin(p);
    extent.high = extent.high.cwiseMax(p);
  }
  return extent;
}

/// Boards run along the house: textures follow the part's axes, so a long house along z is laid
/// turned by a quarter.
void AddFloor(const Surface& surface, std::vector<PlanPoint> outline, bool turned,
              MeshBuilder* builder) {
  if (!turned) {
    builder->Polygon(surface, outline, 0.0f, true);
    return;
  }
  const MeshBuilder::Frame frame(builder, Vec::Zero(), static_cast<float>(-kPi / 2));
  for (PlanPoint& p : outline) p = PlanPoint(p.y(), -p.x());
  builder->Polygon(surface, outline, 0.0f, true);
}

std::vector<const Pit*> PitsOf(const FloorPlan& plan, int room) {
  std::vector<const Pit*> pits;
  for (const Pit& pit : plan.pits) {
    if (pit.room == room) pits.push_back(&pit);
  }
  return pits;
}

struct Pitted {
  std::vector<PlanPoint> outline;
  std::vector<const Pit*> pits;
  bool turned = false;
};

bool IsInPit(const std::vector<const Pit*>& pits, const PlanPoint& point) {
  return std::any_of(pits.begin(), pits.end(), [&](const Pit* pit) {
    return (point - pit->low()).minCoeff() > 0.0f && (pit->high() - point).minCoeff() > 0.0f;
  });
}

/// The floor cut along all lines of its outline and its holes, so that it has no cracks.
void AddFloorAround(const Surface& surface, const Pitted& floor, MeshBuilder* builder) {
  std::array<std::set<float>, 2> cuts;
  for (int axis = 0; axis < 2; ++axis) {
    auto& here = cuts[static_cast<std::size_t>(axis)];
    for (const PlanPoint& p : floor.outline) here.insert(p[axis]);
    for (const Pit* pit : floor.pits) here.insert({pit->low()[axis], pit->high()[axis]});
  }
  for (auto x = cuts[0].begin(); std::next(x) != cuts[0].end(); ++x) {
    for (auto y = cuts[1].begin(); std::next(y) != cuts[1].end(); ++y) {
      const PlanPoint low(*x, *y);
      const PlanPoint high(*std::next(x), *std::next(y));
      const PlanPoint middle = 0.5f * (low + high);
      if (!IsInside(floor.outline, middle) || IsInPit(floor.pits, middle)) continue;
      AddFloor(surface, {low, {low.x(), high.y()}, high, {high.x(), low.y()}}, floor.turned,
               builder);
    }
  }
}

/// The stretches of the line `at` across the room, along x or along z.
std::vector<float> Crossings(const std::vector<PlanPoint>& outline, bool along_x, float at) {
  const int across = along_x ? 1 : 0;
  std::vector<float> cuts;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint& p = outline[i];
    const PlanPoint& q = outline[(i + 1) % outline.size()];
    if ((p[across] > at) != (q[across] > at)) cuts.push_back(p[1 - across]);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

void AddBeams(const Surface& surface, const std::vector<PlanPoint>& outline, float ceiling,
              MeshBuilder* builder) {
  const Extent extent = ExtentOf(outline);
  const PlanPoint size = extent.high - extent.low;
  const bool along_x = size.x() < size.y();  // over the shorter span
  const int across = along_x ? 1 : 0;
  const int count = static_cast<int>(size[across] / kBeamSpacing);
  for (int i = 0; i < count; ++i) {
    const float at = extent.low[across] +
                     size[across] * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const std::vector<float> cuts = Crossings(outline, along_x, at);
    for (std::size_t k = 0; k + 1 < cuts.size(); k += 2) {
      const MeshBuilder::Frame frame(builder, along_x
                                                  ? FaceFrame({cuts[k], at}, {cuts[k + 1], at})
                                                  : FaceFrame({at, cuts[k]}, {at, cuts[k + 1]}));
      AddBar(surface, {0.0f, ceiling - kBeamDepth, cuts[k + 1] - cuts[k], ceiling},
             -0.5f * kBeamWidth, 0.5f * kBeamWidth, Grain::kLevel, builder);
    }
  }
}

}  // namespace

void AddFloorAndCeiling(const FloorPlan& plan, const HouseStyle& style, int room,
                        MeshBuilder* builder) {
  const auto& outline = plan.rooms[static_cast<std::size_t>(room)].outline;
  const std::string& name = plan.rooms[static_cast<std::size_t>(room)].name;
  const RoomStyle& look = style.rooms[static_cast<std::size_t>(room)];
  const Extent house = ExtentOf(plan.footprint);
  const bool is_deep = (house.high - house.low).y() > (house.high - house.low).x();
  const std::vector<PlanPoint> wide = Grown(outline, 0.5f * InnerThickness(plan) + kSeam);
  const std::vector<const Pit*> pits = PitsOf(plan, room);
  builder->BeginObject("floor", name);
  if (pits.empty()) {
    AddFloor(look.floor, wide, is_deep, builder);
  } else {
    AddFloorAround(look.floor, {wide, pits, is_deep}, builder);
  }
  builder->BeginObject("ceiling", name);
  builder->Polygon(look.ceiling, wide, plan.ceiling, false);
  if (!look.beams) return;
  builder->BeginObject("beams", name);
  AddBeams(*look.beams, outline, plan.ceiling, builder);
}

}  // namespace bulletnav::sim::shell
