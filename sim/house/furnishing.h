// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include <Eigen/Geometry>

namespace bulletnav::sim {

/// A piece of furniture where it stands or hangs.
struct Furnishing {
  std::string kind;                               // "office_chair"
  int room = -1;                                  // index into FloorPlan::rooms
  Eigen::Vector3f low = Eigen::Vector3f::Zero();  // its box along its own axes, in its frame
  Eigen::Vector3f high = Eigen::Vector3f::Zero();
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  // of its frame in the world
  float yaw = 0.0f;       // of its frame about y, radians: 0 looks along +z
  std::string name = {};  // of its SceneObject: "office_chair_3"; empty if that is not known
};

}  // namespace bulletnav::sim
