// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>

#include "sim/house/mesh_builder.h"
#include "sim/house/palette.h"
#include "sim/math/rng.h"

namespace bulletnav::sim {

/// Where a piece of furniture belongs.
enum class Placement {
  kAgainstWall,  // its back to a wall
  kCorner,       // its back and its left side (x low) to walls
  kFree,         // in the open, walkable around
  kOnWall,       // hung on a wall
  kCeiling,      // hung from the ceiling
  kOnTop,        // stands on another piece
  kRug           // flat on the floor, other pieces may stand on it
};

/// A kind of furniture. Its frame: it stands on y = 0 (kCeiling: hangs down from y = 0; kOnWall:
/// y = 0 is its lower edge), its back lies in the plane z = 0 and it extends towards +z, its front;
/// x is centred on 0. Pieces that stand free are centred on (0, 0) in x and z.
/// Size and details are drawn from `rng`, colours come from the room's palette.
struct FurnitureKind {
  std::string_view name;  // "double_bed"
  Placement placement = Placement::kAgainstWall;
  float clearance = 0.0f;  // free floor wanted in front of it, metres
  void (*build)(MeshBuilder* builder, Rng& rng, const Palette& palette) = nullptr;
};

/// Every kind, sorted by name; at least 40.
std::span<const FurnitureKind> AllFurniture();

/// Throws Error, naming the nearest known name, if there is no such kind.
const FurnitureKind& FindFurniture(std::string_view name);

}  // namespace bulletnav::sim
