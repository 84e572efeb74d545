// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "sim/scene/damage.h"

namespace bulletnav::sim {

/// Smears textures along a line each, in patches, and washes out colours of vertices in others.
void SmearColors(const Smears& smears, std::uint64_t seed, SceneMesh* mesh);

}  // namespace bulletnav::sim
