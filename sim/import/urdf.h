// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "sim/config/enum_names.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

struct UrdfVisual {
  std::filesystem::path asset;  // a mesh file, or empty:
  SceneMesh shape;              // then this
  /// From the mesh's axes and units to the link's.
  Eigen::Affine3f X_LA = Eigen::Affine3f::Identity();
};

struct UrdfLink {
  std::string name;
  std::vector<UrdfVisual> visuals;
};

/// Planar, floating and spherical joints are taken to be fixed.
enum class UrdfJointType { kFixed, kRevolute, kContinuous, kPrismatic, kPlanar, kFloating, kBall };

template <>
struct EnumNames<UrdfJointType> {
  static constexpr std::array kNames = {std::pair{"fixed", UrdfJointType::kFixed},
                                        std::pair{"revolute", UrdfJointType::kRevolute},
                                        std::pair{"continuous", UrdfJointType::kContinuous},
                                        std::pair{"prismatic", UrdfJointType::kPrismatic},
                                        std::pair{"planar", UrdfJointType::kPlanar},
                                        std::pair{"floating", UrdfJointType::kFloating},
                                        std::pair{"spherical", UrdfJointType::kBall}};
};

struct UrdfJoint {
  std::string name;
  UrdfJointType type = UrdfJointType::kFixed;
  std::size_t parent = 0;  // links
  std::size_t child = 0;
  Eigen::Affine3f X_PJ = Eigen::Affine3f::Identity();  // the joint at 0, in the parent link
  Eigen::Vector3f axis = Eigen::Vector3f::UnitX();     // unit
  double lower = 0.0;                                  // radians or metres
  double upper = 0.0;
  std::optional<double> angle_at_zero;  // see kAngleAtZero

  /// Whether it takes one of an object's joint positions.
  bool moves() const {
    return type == UrdfJointType::kRevolute || type == UrdfJointType::kContinuous ||
           type == UrdfJointType::kPrismatic;
  }
};

/// What a URDF shows and how it moves. Masses and colliders are not read.
struct Urdf {
  std::vector<UrdfLink> links;
  /// Each behind those above it: depth first, those on one link by name, which is how habitat-sim
  /// numbers them.
  std::vector<UrdfJoint> joints;
  std::map<std::string, int> left_out;  // what is not drawn, and how often
};

/// Reads a URDF: links with their visuals (meshes relative to its folder, boxes, cylinders and
/// spheres) and joints; revolute ones whose lower limit is above the upper one are continuous.
/// Links without mass, several roots, and numbers with commas between them are taken, as
/// habitat-sim takes them. Throws FileError with the line: no XML, no robot, a mesh that is not
/// there, links and joints that are missing, double or in a circle, bad numbers.
Urdf ReadUrdf(const std::filesystem::path& file);

}  // namespace bulletnav::sim
