// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "sim/scene/damage.h"

namespace bulletnav::sim {

/// Takes patches out of a mesh; those of dark materials, of ceilings and of what is called window,
/// glass, mirror, screen or metal more readily than others. At least one triangle stays.
void PunchHoles(const Holes& holes, std::uint64_t seed, SceneMesh* mesh);

/// Takes a share of the floor out and mirrors the room below it; nothing where the scene goes on
/// more than 1 m below its floor, as houses of several storeys do.
void MirrorFloor(double share, std::uint64_t seed, SceneMesh* mesh);

}  // namespace bulletnav::sim
