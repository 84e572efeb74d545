// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "sim/scene/damage.h"

namespace bulletnav::sim {

/// Adds a second shell beside patches of a mesh, all in one direction along the ground; floors have
/// none.
void DoubleSurfaces(const Doubled& doubled, std::uint64_t seed, SceneMesh* mesh);

}  // namespace bulletnav::sim
