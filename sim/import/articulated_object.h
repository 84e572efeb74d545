// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "sim/import/scene_parts.h"
#include "sim/import/urdf.h"

namespace bulletnav::sim {

/// Something with joints that stands in a scene, y up.
struct ArticulatedObject {
  std::string category;
  std::string name;  // no other's
  /// From the axes of its root link to the scene's: turned and moved.
  Eigen::Affine3f X_WR = Eigen::Affine3f::Identity();
  float scale = 1.0f;
  /// Where its joints that move stand, in their order, radians or metres; at 0 where too few.
  std::vector<double> positions;
  std::string place;  // in the scene's file, for complaints
};

/// Adds what a URDF shows. Links on a revolute joint that is upright, and all that hangs on them,
/// are a door each, of the category `door`.
void AddArticulated(const Urdf& model, const ArticulatedObject& object, SceneParts* scene);

}  // namespace bulletnav::sim
