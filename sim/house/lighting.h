// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "sim/house/mesh_builder.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

struct LightSpec {
  float coarse_edge_m = 1.4f;  // longer edges are always halved
  float fine_edge_m = 0.35f;   // edges are halved down to this where light changes along them
  float change = 0.1f;         // by this share of full light
  int min_triangles = 0;       // below this, edges are halved down to less
  int max_triangles = 60'000;  // above this, no further round of halving
  float lamp_power = 0.62f;    // of one lamp, whatever its size
  float ambient = 0.16f;       // light that has bounced more than once
};

/// Bakes soft light into a house's vertex colours: daylight from the windows (Glow::kSky), lamps
/// (Glow::kLamp), one bounce off coloured surfaces, ambient occlusion. First halves edges so that
/// the light's gradients have vertices to stand on. Parts that glow stay at full brightness.
/// `glows`: one a triangle, as from MeshBuilder.
/// Source: radiosity gathered at vertices with Embree, tone-mapped; ours.
void BakeLight(SceneMesh* mesh, std::span<const Glow> glows, const LightSpec& spec = {});

}  // namespace bulletnav::sim
