// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>
#include <vector>

#include "sim/house/building/hall.h"

namespace bulletnav::sim::building {

/// The one of a hall's four ways that leads best from its middle to `target`.
Look LookTowards(const Hall& hall, const PlanPoint& target);
/// The way a piece in the hall looks.
Look LookOf(const Hall& hall, const Placed& piece);
Look Opposite(Look look);

/// Pieces in rows that all look at one wall: desks before a board, chairs before a stage. Metres.
struct Audience {
  std::string_view kind;
  float width = 1.3f;   // of a piece
  float pitch = 1.5f;   // from row to row
  float first = 2.4f;   // from the wall looked at to the middle of the first row
  float last = 0.9f;    // kept behind the last row's middle
  float side = 0.8f;    // kept beside the rows
  float gap = 0.6f;     // between pieces of a row
  float aisle = 0.0f;   // a way through the rows' middle, wider than a gap
  double share = 0.95;  // of the places that are taken
};

/// Returns how many pieces.
int Seat(Hall* hall, Look look, const Audience& audience);

/// Pieces against walls, `pitch` metres apart on each wall, as many as fit and no more than `most`.
std::vector<const Placed*> LineWalls(RoomFurnisher* room, std::string_view kind, float pitch,
                                     int most);

/// A glazed wall with mullions across the hall at `u` up to the ceiling, with a way through it.
void GlazedWall(Hall* hall, float u);

/// Tables with chairs in a grid.
void Tables(Hall* hall, std::string_view table, float width, const Field& field);

/// Shower, toilet and basin on a few square metres: of a hotel room, of a ward.
void FurnishWetCell(RoomFurnisher* room);
/// Tables, a buffet along a wall: canteens, breakfast rooms.
void FurnishCanteen(RoomFurnisher* room);

}  // namespace bulletnav::sim::building
