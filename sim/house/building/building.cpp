// SPDX-License-Identifier: MIT
#include "sim/house/building/building.h"

#include <algorithm>

#include "sim/house/architecture.h"
#include "sim/house/building/decorate.h"
#include "sim/house/furnish.h"
#include "sim/house/hidden.h"
#include "sim/house/lighting.h"

namespace bulletnav::sim::building {
namespace {

/// Lamps that hang higher are stronger; large buildings get no finer light than small ones.
LightSpec LightOf(const FloorPlan& plan) {
  constexpr float kHomeCeiling = 2.6f;
  LightSpec light;
  const float high = std::max(1.0f, plan.ceiling / kHomeCeiling);
  light.lamp_power *= high * high;
  light.ambient = 0.2f;
  light.coarse_edge_m = 1.8f;
  light.fine_edge_m = plan.area() < 300.0f ? 0.4f : 0.7f;
  light.max_triangles = 120'000;
  return light;
}

}  // namespace

House GenerateBuilding(const BuildingKind& kind, std::uint64_t seed, TextureCache* textures,
                       const AreaLimits& limits, const Refurnish& refurnish) {
  const Rng rng = Rng(seed, "building").Fork(kind.name);
  House building;
  building.kind = kind.name;
  building.seed = seed;
  building.plan = GenerateBuildingPlan(kind, rng.Fork("plan"), limits);
  building.style = DrawBuildingStyle(kind, building.plan, rng.Fork("style"));
  MeshBuilder builder;
  BuildArchitecture(building.plan, building.style, &builder);
  building.furniture = FurnishRooms(building.plan, building.style, kind.furnish,
                                    rng.Fork("furnish"), &builder, refurnish);
  building.mesh = builder.Finish(textures);
  std::vector<Glow> glows = builder.glows();
  RemoveHidden(&building.mesh, &glows);
  BakeLight(&building.mesh, glows, LightOf(building.plan));
  return building;
}

}  // namespace bulletnav::sim::building
