// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>

#include "sim/house/building/bands.h"
#include "sim/house/house_style.h"
#include "sim/house/placing/room_furnisher.h"

namespace bulletnav::sim::building {

/// Surfaces that a kind of building chooses from. Lists are not empty.
struct Looks {
  std::span<const Surface> floors;       // of most rooms
  std::span<const Surface> hard_floors;  // where it gets wet or heavy
  std::span<const Surface> soft_floors;  // of rooms to sit or sleep in
  std::span<const Surface> walls;
  std::span<const Surface> accents;  // of some rooms' one wall, or lower part
  std::span<const Surface> ceilings;
  std::span<const StyleKind> books;  // whose furniture stands in it
  double accent_chance = 0.3;
};

/// Clear heights of ceilings, metres.
struct Heights {
  float low = 2.6f;
  float high = 3.0f;
};

/// Holes in floors besides those of stairwells.
struct PitHabit {
  RoomType room = RoomType::kShopFloor;
  double chance = 0.0;
  bool is_narrow = false;  // to work in under a car; else a void or a way down
};

/// What offices, shops and so on are: rooms, looks, furniture. One file each in this folder.
struct BuildingKind {
  std::string_view name;
  float min_area_m2 = 100.0f;
  float max_area_m2 = 2000.0f;
  Heights ceiling;
  Looks looks;
  /// Lays out about `area` square metres; a draft that does not work out is drawn again.
  void (*lay)(float area, Sketch* sketch, Rng* rng) = nullptr;
  /// Furnishes a room of a type that `lay` uses.
  void (*furnish)(RoomType type, placing::RoomFurnisher* room) = nullptr;
  /// A hole in the floor of each large room of a type, with a chance; stairwells have one anyhow.
  PitHabit pits = {};
};

/// The kinds, one function a file.
const BuildingKind& Clinic();
const BuildingKind& Hotel();
const BuildingKind& Loft();
const BuildingKind& Office();
const BuildingKind& School();
const BuildingKind& Shop();
const BuildingKind& Warehouse();
const BuildingKind& Workshop();

/// All of them, in the order of their names.
std::span<const BuildingKind* const> AllKinds();

/// Throws Error, naming the nearest known name, if there is no such kind.
const BuildingKind& FindKind(std::string_view name);

}  // namespace bulletnav::sim::building
