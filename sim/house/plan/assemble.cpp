// SPDX-License-Identifier: MIT
#include "sim/house/plan/assemble.h"

#include <algorithm>
#include <bit>
#include <map>

namespace bulletnav::sim::plan {
namespace {

PlanPoint Metres(const GridPoint& p) {
  return {0.01f * static_cast<float>(p.x), 0.01f * static_cast<float>(p.y)};
}

/// The loop moved to its left by `inset` metres; negative moves it outwards.
std::vector<PlanPoint> Inset(const std::vector<GridPoint>& loop, float inset) {
  std::vector<PlanPoint> moved;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const PlanPoint before = Metres(loop[(i + n - 1) % n]);
    const PlanPoint here = Metres(loop[i]);
    const PlanPoint after = Metres(loop[(i + 1) % n]);
    const PlanPoint left =
        LeftOf((here - before).normalized()) + LeftOf((after - here).normalized());
    moved.push_back(here + inset * left);
  }
  return moved;
}

void AddInnerWalls(const Layout& layout, std::vector<Wall>* walls) {
  std::vector<Border> lines;
  for (const Border& border : layout.borders) {
    if (border.low == kOutside || border.high == kOutside) continue;
    const bool continues = !lines.empty() && lines.back().is_vertical == border.is_vertical &&
                           lines.back().at == border.at && lines.back().to == border.from;
    if (continues) {
      lines.back().to = border.to;
    } else {
      lines.push_back(border);
    }
  }
  for (const Border& line : lines) {
    const GridPoint a =
        line.is_vertical ? GridPoint{line.at, line.from} : GridPoint{line.from, line.at};
    const GridPoint b =
        line.is_vertical ? GridPoint{line.at, line.to} : GridPoint{line.to, line.at};
    const float thickness = 0.01f * static_cast<float>(layout.draft.wall_cm);
    walls->push_back({Metres(a), Metres(b), thickness, false});
  }
}

void AddOuterWalls(const Layout& layout, const std::vector<GridPoint>& loop,
                   std::vector<Wall>* walls) {
  const auto extra = static_cast<float>(layout.draft.outer_cm - layout.draft.wall_cm);
  const std::vector<PlanPoint> middle = Inset(loop, -0.005f * extra);
  const float thickness = 0.01f * static_cast<float>(layout.draft.outer_cm);
  for (std::size_t i = 0; i < middle.size(); ++i) {
    walls->push_back({middle[i], middle[(i + 1) % middle.size()], thickness, true});
  }
}

void NameRooms(FloorPlan* plan) {
  std::map<RoomType, int> count;
  for (const Room& room : plan->rooms) ++count[room.type];
  std::map<RoomType, int> used;
  for (Room& room : plan->rooms) {
    room.name = NameOf(room.type);
    if (count[room.type] > 1) room.name.append("_").append(std::to_string(++used[room.type]));
  }
}

/// Applies `f` to every point of the plan.
template <class F>
void MovePoints(const F& f, FloorPlan* plan) {
  for (Room& room : plan->rooms) {
    for (PlanPoint& p : room.outline) p = f(p);
  }
  for (Wall& wall : plan->walls) {
    wall.a = f(wall.a);
    wall.b = f(wall.b);
  }
  for (Opening& opening : plan->openings) {
    opening.a = f(opening.a);
    opening.b = f(opening.b);
  }
  for (PlanPoint& p : plan->footprint) p = f(p);
}

void Centre(FloorPlan* plan) {
  PlanPoint low = plan->footprint.front();
  PlanPoint high = low;
  for (const PlanPoint& p : plan->footprint) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const PlanPoint centre = 0.5f * (low + high);
  MovePoints(
      [&](const PlanPoint& p) -> PlanPoint {
        return p - centre;
      },
      plan);
}

/// After mirroring, loops run the wrong way around and openings have their rooms on wrong sides.
void RestoreOrder(FloorPlan* plan) {
  for (Room& room : plan->rooms) std::reverse(room.outline.begin(), room.outline.end());
  std::reverse(plan->footprint.begin(), plan->footprint.end());
  for (Opening& opening : plan->openings) {
    std::swap(opening.a, opening.b);
    opening.hinge_at_a = !opening.hinge_at_a;
  }
}

}  // namespace

FloorPlan Assemble(const Layout& layout, std::vector<Opening> openings) {
  const CellGrid grid(layout.draft);
  const float half_wall = 0.005f * static_cast<float>(layout.draft.wall_cm);
  const float outer = 0.01f * static_cast<float>(layout.draft.outer_cm) - half_wall;
  FloorPlan plan;
  for (int i = 0; i < static_cast<int>(layout.draft.rooms.size()); ++i) {
    const auto loop = grid.Outline([&](int owner) {
      return owner == i;
    });
    plan.rooms.push_back({layout.draft.type(i), {}, Inset(loop, half_wall)});
  }
  NameRooms(&plan);
  const auto footprint = grid.Outline([](int owner) {
    return owner != kOutside;
  });
  plan.footprint = Inset(footprint, -outer);
  AddOuterWalls(layout, footprint, &plan.walls);
  AddInnerWalls(layout, &plan.walls);
  plan.openings = std::move(openings);
  Centre(&plan);
  return plan;
}

void Turn(int how, FloorPlan* plan) {
  const auto turn = [how](const PlanPoint& p) -> PlanPoint {
    const PlanPoint q((how & 1) != 0 ? -p.x() : p.x(), (how & 2) != 0 ? -p.y() : p.y());
    return (how & 4) != 0 ? PlanPoint(q.y(), q.x()) : q;
  };
  MovePoints(turn, plan);
  for (Pit& pit : plan->pits) {
    for (PlanPoint* p : {&pit.corner, &pit.into, &pit.across}) *p = turn(*p);
  }
  if (std::popcount(static_cast<unsigned>(how) & 7u) % 2 == 1) RestoreOrder(plan);
}

}  // namespace bulletnav::sim::plan
