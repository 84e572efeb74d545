// SPDX-License-Identifier: MIT
#include "tests/support/houses.h"

#include <string>

#include <fmt/core.h>

#include "sim/base/files.h"
#include "sim/house/architecture.h"
#include "sim/house/floor_plan_generator.h"
#include "sim/house/house_style.h"
#include "sim/house/mesh_builder.h"
#include "sim/scene/glb_writer.h"

namespace bulletnav::tests {
namespace {

sim::SceneMesh Shell(const sim::Rng& rng, sim::TextureCache* textures) {
  const sim::FloorPlan plan = sim::GenerateFloorPlan(rng);
  sim::MeshBuilder builder;
  sim::BuildArchitecture(plan, sim::DrawHouseStyle(plan, rng), &builder);
  return builder.Finish(textures);
}

}  // namespace

sim::SceneMesh ShellHouse(std::uint64_t seed) {
  sim::TextureCache textures;
  sim::SceneMesh mesh = Shell(sim::Rng(seed, "shell_house"), &textures);
  mesh.textures.clear();  // pictures play no part in how agents move, and take long to prepare
  for (sim::Material& material : mesh.materials) material.texture = -1;
  return mesh;
}

void WriteShellHouses(const std::filesystem::path& folder, int count, int test) {
  std::string entries;
  sim::TextureCache textures;
  for (int i = 0; i < count; ++i) {
    const sim::Rng rng = sim::Rng(5, "shell").Fork("house", static_cast<std::uint64_t>(i));
    const std::string name = fmt::format("house_{:03}.glb", i);
    sim::WriteFileAtomically(folder / name, sim::EncodeGlb(Shell(rng, &textures)));
    entries += fmt::format(R"({}{{"file": "{}", "split": "{}", "seed": {}}})", i > 0 ? ", " : "",
                           name, i < count - test ? "train" : "test", i);
  }
  sim::WriteFileAtomically(folder / "index.json", "{\"houses\": [" + entries + "]}\n");
}

}  // namespace bulletnav::tests
