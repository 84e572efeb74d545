// SPDX-License-Identifier: MIT
#pragma once
#include "sim/import/assimp_scene.h"
#include "sim/scene/import.h"

namespace bulletnav::sim {

/// Decodes a mesh's textures one by one, and halves each until a texel covers at least 2 mm of the
/// surfaces that show it, on average: a panorama of 512 columns sees that from 0.2 m. What no
/// triangle uses becomes a single texel. Large pictures on small things shrink to what can be seen
/// of them, so that no more than one is held whole.
/// What cannot be decoded is drawn grey, taken out of the mesh and named in the report.
void LoadTextures(const AssimpScene& source, SceneMesh* mesh, ImportReport* report);

}  // namespace bulletnav::sim
