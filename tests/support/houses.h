// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>

#include "sim/scene/mesh.h"

namespace bulletnav::tests {

/// The shell of a generated house: walls, doors and windows in flat colours, no furniture.
sim::SceneMesh ShellHouse(std::uint64_t seed);

/// Writes `count` unfurnished procedural houses house_000.glb, ... and their index.json, in which
/// the first `count - test` are of the split "train" and the others of "test".
void WriteShellHouses(const std::filesystem::path& folder, int count, int test);

}  // namespace bulletnav::tests
