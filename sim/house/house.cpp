// SPDX-License-Identifier: MIT
#include "sim/house/house.h"

#include "sim/house/architecture.h"
#include "sim/house/furnish.h"
#include "sim/house/hidden.h"

namespace bulletnav::sim {

House GenerateHouse(std::uint64_t seed, TextureCache* textures, const PlanOptions& plan,
                    const LightSpec& light, const Refurnish& refurnish) {
  const Rng rng(seed, "house");
  House house;
  house.seed = seed;
  house.plan = GenerateFloorPlan(rng.Fork("plan"), plan);
  house.style = DrawHouseStyle(house.plan, rng.Fork("style"));
  MeshBuilder builder;
  BuildArchitecture(house.plan, house.style, &builder);
  house.furniture = FurnishRooms(house.plan, house.style, FurnishHomeRoom, rng.Fork("furnish"),
                                 &builder, refurnish);
  house.mesh = builder.Finish(textures);
  std::vector<Glow> glows = builder.glows();
  RemoveHidden(&house.mesh, &glows);
  BakeLight(&house.mesh, glows, light);
  return house;
}

}  // namespace bulletnav::sim
