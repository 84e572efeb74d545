// SPDX-License-Identifier: MIT
#pragma once
#include "sim/render/cpu/bvh.h"
#include "sim/render/render_mesh.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Gives a hierarchy over a scene's triangles coarse copies of its parts, to be drawn where they
/// are so far away that they are wrong by less than half a pixel (see BvhNode). Small patches are
/// simplified a little, large ones more. Coarse triangles are added to the end of `mesh`.
/// Expects `mesh` and `bvh` to have been made of the scene. The same on every processor.
void AddLevelsOfDetail(const SceneMesh& scene, RenderMesh* mesh, Bvh* bvh);

}  // namespace bulletnav::sim
