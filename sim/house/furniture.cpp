// SPDX-License-Identifier: MIT
#include "sim/house/furniture.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/piece_maker.h"

namespace bulletnav::sim {
namespace {

using Vec = MeshBuilder::Vec;

std::vector<FurnitureKind> Collect() {
  using namespace furniture;
  std::vector<FurnitureKind> all;
  for (const auto& family : {Bathroom(),       BathroomFittings(),
                             Beds(),           Cabinets(),
                             CeilingLamps(),   Chairs(),
                             FloorClutter(),   Hall(),
                             Hobbies(),        HomeClutter(),
                             Kids(),           KitchenAppliances(),
                             KitchenClutter(), KitchenRuns(),
                             Lamps(),          Laundry(),
                             Plants(),         Rugs(),
                             Screens(),        Shelves(),
                             Sofas(),          Study(),
                             Tables(),         Toys(),
                             WallArt(),        Windows(),
                             Fixtures(),       Industry(),
                             Workplaces(),     Clinic(),
                             ClinicBeds(),     Hotel(),
                             Laboratory(),     School(),
                             ShopDisplays(),   ShopFittings(),
                             Tools(),          Vehicles()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.name < b.name;
  });
  return all;
}

/// How far a piece has to be moved so that it lies in its frame as its placement says. Legs that
/// lean end a little above or below the floor: the piece is set down on it.
Vec MoveIntoFrame(Placement placement, const Eigen::AlignedBox3f& bounds) {
  constexpr float kNearFloor = 0.03f;
  const Vec centre = bounds.center();
  const float low = bounds.min().y();
  const float down = std::abs(low) < kNearFloor ? -low : 0.0f;
  switch (placement) {
    case Placement::kAgainstWall:
    case Placement::kCorner:
    case Placement::kOnWall:
      return {-centre.x(), down, -bounds.min().z()};
    case Placement::kFree:
    case Placement::kCeiling:
    case Placement::kOnTop:
    case Placement::kRug:
      break;
  }
  return {-centre.x(), down, -centre.z()};
}

}  // namespace

Piece BuildPiece(const FurnitureKind& kind, const Rng& rng, const Palette& palette,
                 const PieceRequest& request) {
  PieceRequest granted = request;
  if (granted.width > 0.0f) {
    granted.width = std::clamp(granted.width, kind.min_width, kind.max_width);
  }
  furniture::PieceMaker maker(rng, palette, granted);
  kind.build(maker);
  BULLETNAV_CHECK_GT(maker.triangles(), 0u);
  const Vec move = MoveIntoFrame(kind.placement, maker.Bounds());
  Piece piece;
  {
    const MeshBuilder::Frame frame(&piece.mesh, move);
    piece.mesh.Append(maker);
  }
  for (const TopSurface& top : maker.tops()) {
    const MeshBuilder::Vec2 shift(move.x(), move.z());
    piece.tops.push_back({top.height + move.y(), {top.area.min() + shift, top.area.max() + shift}});
  }
  std::stable_sort(piece.tops.begin(), piece.tops.end(), [](const auto& a, const auto& b) {
    return a.area.volume() > b.area.volume();
  });
  return piece;
}

std::span<const FurnitureKind> AllFurniture() {
  static const std::vector<FurnitureKind> all = Collect();
  return all;
}

const FurnitureKind& FindFurniture(std::string_view name) {
  const auto all = AllFurniture();
  const auto found =
      std::lower_bound(all.begin(), all.end(), name, [](const FurnitureKind& k, auto n) {
        return k.name < n;
      });
  if (found != all.end() && found->name == name) return *found;
  std::vector<std::string> names;
  for (const FurnitureKind& kind : all) names.emplace_back(kind.name);
  throw Error("no furniture '" + std::string(name) + "'; did you mean '" +
              NearestWord(name, names) + "'?");
}

}  // namespace bulletnav::sim
