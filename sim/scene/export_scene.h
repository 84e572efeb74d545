// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sim/scene/doors.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

enum class SceneFormat {
  kSceneInstance,  // Habitat's, with its data set's config
  kSdf             // a world of Gazebo's, z up
};

/// Writes a scene as a stage (walls, floors and what else is built in) and one static object for
/// each other object of the mesh, all as glb files that keep categories, names and rooms, into
/// `folder`, which may hold other scenes already:
///   kSceneInstance: scenes/NAME.scene_instance.json, stages/NAME.*, objects/NAME/*, urdf/NAME/*,
///   and
///     bulletnav.scene_dataset_config.json, which is the same for all scenes;
///   kSdf: NAME.sdf and NAME/*.glb. Gazebo takes glTF in its own axes since Garden.
/// `doors` of the mesh, those that lead outside apart, hang on revolute joints, as they stand.
/// Returns the scene's file. ImportScene reads it back as the same triangles in another order, with
/// the same doors. Throws Error for a name that is no plain file name, FileError if a file cannot
/// be written.
std::filesystem::path ExportScene(const SceneMesh& mesh, const std::string& name,
                                  SceneFormat format, const std::filesystem::path& folder,
                                  const std::vector<DoorLeaf>& doors = {});

}  // namespace bulletnav::sim
