// SPDX-License-Identifier: MIT
#include "tests/support/houses.h"

#include "sim/house/architecture.h"
#include "sim/house/floor_plan_generator.h"
#include "sim/house/house_style.h"
#include "sim/house/mesh_builder.h"

namespace bulletnav::tests {

sim::SceneMesh ShellHouse(std::uint64_t seed) {
  const sim::Rng rng(seed, "shell_house");
  const sim::FloorPlan plan = sim::GenerateFloorPlan(rng);
  sim::MeshBuilder builder;
  sim::BuildArchitecture(plan, sim::DrawHouseStyle(plan, rng), &builder);
  sim::TextureCache textures;
  sim::SceneMesh mesh = builder.Finish(&textures);
  mesh.textures.clear();  // pictures play no part in how agents move, and take long to prepare
  for (sim::Material& material : mesh.materials) material.texture = -1;
  return mesh;
}

}  // namespace bulletnav::tests
