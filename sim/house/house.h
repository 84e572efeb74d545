// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "sim/house/floor_plan_generator.h"
#include "sim/house/furnishing.h"
#include "sim/house/house_style.h"
#include "sim/house/lighting.h"
#include "sim/house/refurnish.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// A furnished home or other building: its shell, furniture by room type, light baked into its
/// vertex colours.
struct House {
  std::uint64_t seed = 0;
  std::string kind = "home";  // or another in building::AllKinds
  FloorPlan plan;
  HouseStyle style;
  std::vector<Furnishing> furniture;
  SceneMesh mesh;
};

/// How homes are lit: those of few triangles are cut finer than LightSpec says.
inline constexpr LightSpec kHomeLight = {.min_triangles = 24'000};

/// Draws a house from its seed. Frame: the world's, the floor at y = 0, about the origin. The same
/// seed gives the same house to the last bit on every machine.
/// `textures`: pictures to share between calls; one per thread. Cost: seconds, most of them light.
House GenerateHouse(std::uint64_t seed, TextureCache* textures, const PlanOptions& plan = {},
                    const LightSpec& light = kHomeLight, const Refurnish& refurnish = {});

}  // namespace bulletnav::sim
