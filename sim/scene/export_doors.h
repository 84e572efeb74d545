// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "sim/scene/doors.h"

namespace bulletnav::sim {

/// A door's leaf in a file of its own, around its hinge.
struct ExportedDoor {
  std::string name;  // a plain file name
  std::string mesh;  // the file with the leaf, from where the text will lie
  DoorLeaf leaf;
};

/// A model of a world, z up, that turns about the world's upright on one revolute joint, with
/// limits where the door is shut and open. The mesh is as the leaf stands; the joint is 0 there.
std::string SdfDoor(const ExportedDoor& door);

/// A URDF, y up, with a root without mass and the leaf on one revolute joint. The mesh is as the
/// leaf would stand at an angle of 0; the joint is 0 there.
std::string UrdfDoor(const ExportedDoor& door);

}  // namespace bulletnav::sim
