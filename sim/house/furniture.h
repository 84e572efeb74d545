// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "sim/house/mesh_builder.h"
#include "sim/house/palette.h"
#include "sim/math/rng.h"

namespace bulletnav::sim {

namespace furniture {
class PieceMaker;
}

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
/// x is centred on 0. Pieces that stand free (kFree, kCeiling, kOnTop, kRug) are centred on (0, 0)
/// in x and z; chairs and the like look towards +z.
struct FurnitureKind {
  std::string_view name;  // "double_bed"
  Placement placement = Placement::kAgainstWall;
  float clearance = 0.0f;  // free floor wanted in front of it (kFree: around it), metres
  void (*build)(furniture::PieceMaker& maker) = nullptr;
  float min_width = 0.0f;  // the widths it can be asked for; both 0: it does not stretch
  float max_width = 0.0f;
};

/// What a place asks of a piece, metres; 0 leaves it to the kind.
struct PieceRequest {
  /// Along x. Kinds that stretch take it, clamped to what they can be; the others ignore it.
  float width = 0.0f;
  /// Curtains and blinds: how far they reach down. Everything against a wall: nothing higher than
  /// this, where the kind has parts it can leave out (wall cabinets, hoods and mirrors, so that a
  /// window fits above).
  float height = 0.0f;
};

/// A level place where small things can stand, in the piece's frame.
struct TopSurface {
  float height = 0.0f;
  Eigen::AlignedBox2f area;  // (x, z)
};

struct Piece {
  MeshBuilder mesh;
  std::vector<TopSurface> tops;  // the largest first
};

/// Builds one piece: size and details are drawn from `rng`, colours come from the room's palette.
/// The same arguments give the same piece, so chairs that match are built with copies of one rng.
/// The result obeys the frame above exactly: it is moved there along x and z after building.
Piece BuildPiece(const FurnitureKind& kind, const Rng& rng, const Palette& palette,
                 const PieceRequest& request = {});

/// Every kind, sorted by name; at least 100.
std::span<const FurnitureKind> AllFurniture();

/// Throws Error, naming the nearest known name, if there is no such kind.
const FurnitureKind& FindFurniture(std::string_view name);

}  // namespace bulletnav::sim
