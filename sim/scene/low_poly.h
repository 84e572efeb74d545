// SPDX-License-Identifier: MIT
#pragma once
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Coarser shapes: the vertices of a connected part that lie in one cell of a grid move to their
/// middle, and triangles that have no area then go. Cells are `cell` metres, and smaller in thin
/// parts, so that legs of chairs stay. Floors stay as they are.
/// Source: Rossignac and Borrel, "Multi-resolution 3D approximations", 1993.
void ClusterVertices(double cell, SceneMesh* mesh);

/// Colours of textures go into vertices that are `spacing` metres apart, more in large scenes (see
/// RefineTo); there is one white material then and no texture.
void PaintVertices(double spacing, SceneMesh* mesh);

}  // namespace bulletnav::sim
