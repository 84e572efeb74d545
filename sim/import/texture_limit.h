// SPDX-License-Identifier: MIT
#pragma once
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Halves each texture until a texel covers at least 2 mm of the surfaces that show it, on average:
/// a panorama of 512 columns sees that from 0.2 m. What no triangle uses becomes a single texel.
/// Large pictures on small things shrink to what can be seen of them.
void LimitTextures(SceneMesh* mesh);

}  // namespace bulletnav::sim
