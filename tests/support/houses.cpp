// SPDX-License-Identifier: MIT
#include "tests/support/houses.h"

#include <string>

#include <fmt/core.h>

#include "sim/base/files.h"
#include "sim/house/architecture.h"
#include "sim/house/floor_plan_generator.h"
#include "sim/scene/glb_writer.h"

namespace bulletnav::tests {

void WriteShellHouses(const std::filesystem::path& folder, int count, int test) {
  std::string entries;
  sim::TextureCache cache;
  for (int i = 0; i < count; ++i) {
    const sim::Rng rng = sim::Rng(5, "shell").Fork("house", static_cast<std::uint64_t>(i));
    const sim::FloorPlan plan = sim::GenerateFloorPlan(rng);
    sim::MeshBuilder builder;
    sim::BuildArchitecture(plan, sim::DrawHouseStyle(plan, rng), &builder);
    const std::string name = fmt::format("house_{:03}.glb", i);
    sim::WriteFileAtomically(folder / name, sim::EncodeGlb(builder.Finish(&cache)));
    entries += fmt::format(R"({}{{"file": "{}", "split": "{}", "seed": {}}})", i > 0 ? ", " : "",
                           name, i < count - test ? "train" : "test", i);
  }
  sim::WriteFileAtomically(folder / "index.json", "{\"houses\": [" + entries + "]}\n");
}

}  // namespace bulletnav::tests
