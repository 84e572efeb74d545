// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Puts boxes and lumps into a scene: along walls, 6 to 20 cm deep and 10 to 40 cm wide, where a
/// body hardly gets, and on tops. `density`: pieces per 10 m2 of floor. Materials are the scene's.
void AddClutter(double density, std::uint64_t seed, SceneMesh* mesh);

}  // namespace bulletnav::sim
