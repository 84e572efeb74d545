// SPDX-License-Identifier: MIT
#pragma once
#include "sim/scene/mesh.h"

namespace bulletnav::bench {

/// The same surface in about `triangles` triangles, if it has fewer: triangles are cut into four,
/// all of them as often as that goes and then an even share.
sim::SceneMesh Subdivided(const sim::SceneMesh& mesh, std::size_t triangles);

}  // namespace bulletnav::bench
