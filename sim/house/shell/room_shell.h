// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"
#include "sim/house/house_style.h"
#include "sim/house/mesh_builder.h"

namespace bulletnav::sim::shell {

/// A hole in one side of a room, in that side's FaceFrame.
struct Hole {
  float x0 = 0.0f;
  float x1 = 0.0f;
  float bottom = 0.0f;
  float top = 0.0f;
  bool is_cased = false;  // boards stand around it
};

/// One side of a room: seen from inside, x runs from its left end to its right.
struct Side {
  int edge = 0;  // of the outline
  PlanPoint left = PlanPoint::Zero();
  PlanPoint right = PlanPoint::Zero();
  bool left_is_hollow = true;  // the corner there is an inner one, as in a rectangular room
  bool right_is_hollow = true;
  std::vector<Hole> holes;  // from left to right

  float length() const { return (right - left).norm(); }
};

/// All sides of room `room` with their holes.
std::vector<Side> SidesOf(const FloorPlan& plan, const HouseStyle& style, int room);

/// Wall faces, baseboards, ledges and crown moulding of a room.
void AddWalls(const FloorPlan& plan, const HouseStyle& style, int room, MeshBuilder* builder);

/// Floor, ceiling and beams of a room; both run on under the walls to their middle lines.
void AddFloorAndCeiling(const FloorPlan& plan, const HouseStyle& style, int room,
                        MeshBuilder* builder);

}  // namespace bulletnav::sim::shell
