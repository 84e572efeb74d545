// SPDX-License-Identifier: MIT
#pragma once
#include "sim/scene/import.h"

namespace bulletnav::sim {

/// Which way up a mesh is, judged by its floors and ceilings: the axis along which the area of the
/// faces perpendicular to it is gathered in few thin layers, and along which the mesh is low.
/// `usual` (the format's convention) wins unless the other axis is clearly better. Of walls without
/// floor and ceiling, the axis along which nothing faces.
UpAxis DetectUpAxis(const SceneMesh& mesh, UpAxis usual);

/// (x, y, z) -> (x, z, -y).
inline Eigen::Vector3f TurnedZUpToYUp(const Eigen::Vector3f& p) {
  return {p.x(), p.z(), -p.y()};
}

/// Turns a z-up mesh y-up: (x, y, z) -> (x, z, -y).
void TurnZUpToYUp(SceneMesh* mesh);

}  // namespace bulletnav::sim
