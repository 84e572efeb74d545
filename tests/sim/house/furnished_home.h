// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "sim/house/floor_plan_generator.h"
#include "sim/house/furnish.h"

namespace bulletnav::sim {

struct FurnishedHome {
  FloorPlan plan;
  HouseStyle style;
  std::vector<Furnishing> furniture;
};

/// As GenerateHouse, without building and light.
inline FurnishedHome Furnished(std::uint64_t seed, const Refurnish& refurnish = {}) {
  const Rng rng(seed, "house");
  FurnishedHome home;
  home.plan = GenerateFloorPlan(rng.Fork("plan"));
  home.style = DrawHouseStyle(home.plan, rng.Fork("style"));
  MeshBuilder builder;
  home.furniture = FurnishRooms(home.plan, home.style, FurnishHomeRoom, rng.Fork("furnish"),
                                &builder, refurnish);
  return home;
}

}  // namespace bulletnav::sim
