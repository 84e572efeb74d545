// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/style/style_book.h"

namespace bulletnav::sim::style {

/// Surfaces a whole house shares.
struct HouseTheme {
  Surface main_floor;
  Surface bedroom_floor;
  Surface ceiling;
  Surface frame;  // casings, baseboards, mouldings
  Surface wood;   // the one most furniture and the beams are made of
};

HouseTheme DrawTheme(const StyleBook& book, Rng* rng);

/// One way to decorate room `room` of the plan.
RoomStyle DecorateRoom(const StyleBook& book, const HouseTheme& theme, const FloorPlan& plan,
                       int room, Rng* rng);

}  // namespace bulletnav::sim::style
