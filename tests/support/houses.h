// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "sim/scene/mesh.h"

namespace bulletnav::tests {

/// The shell of a generated house: walls, doors and windows in flat colours, no furniture.
sim::SceneMesh ShellHouse(std::uint64_t seed);

}  // namespace bulletnav::tests
