// SPDX-License-Identifier: MIT
#pragma once
#include "sim/scene/mesh.h"

namespace bulletnav::bench {

/// The same surface in at least `triangles` triangles: every triangle is cut into four, as often as
/// it takes.
sim::SceneMesh Subdivided(const sim::SceneMesh& mesh, std::size_t triangles);

}  // namespace bulletnav::bench
