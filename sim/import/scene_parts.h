// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "sim/scene/import.h"

namespace bulletnav::sim {

/// One thing of a scene that is made of several meshes.
struct ScenePart {
  std::filesystem::path asset;  // a mesh file, or empty:
  SceneMesh mesh;               // then this, whose textures are there
  /// From the asset's axes and units, which are not touched, to the scene's.
  Eigen::Affine3f X_WA = Eigen::Affine3f::Identity();
  /// X_WA places the middle of the asset's box, not its origin.
  bool is_centred = false;
  /// Meshes of COLLADA in their own axes, whatever they say is up.
  bool keeps_axes = false;
  /// A rectangle at z = 0, middle at the origin, that ends 1 m beyond all other parts.
  bool ends_with_scene = false;
  /// Not used where the asset says what its triangles belong to. Parts with the same name are one
  /// object, those without one are an object each.
  SceneObject object;
  /// Which of SceneParts::doors this is a part of, -1: none. All parts of a door are one object.
  int door = -1;
  std::string place;  // in the scene's file, for complaints
};

/// A scene as a list: Habitat's and Gazebo's files are read into this.
struct SceneParts {
  std::vector<ScenePart> parts;
  UpAxis up = UpAxis::kY;
  std::vector<std::string> skipped;  // for ImportReport
  std::vector<DoorLeaf> doors = {};  // in the scene's axes, without their objects
};

/// All parts in one mesh, in the scene's axes, not cleaned; every asset is read once, its textures
/// are as LoadTextures leaves them. Names of objects get numbers where they repeat; doors know
/// their objects, and those that show nothing are left out. The report gets textures and skipped
/// lines. Throws FileError with the scene's file and the part's place.
ImportedScene JoinParts(const std::filesystem::path& scene, const SceneParts& parts);

}  // namespace bulletnav::sim
