// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "sim/import/scene_parts.h"

namespace bulletnav::sim {

/// Whether a file is called *.sdf or *.world.
inline bool IsGazeboWorld(const std::filesystem::path& file) {
  return file.extension() == ".sdf" || file.extension() == ".world";
}

/// What a world (or a single model) of Gazebo's SDF consists of, z up: the visuals of all links of
/// all models, nested ones too: meshes, boxes, cylinders, spheres, ellipsoids and planes, which end
/// 1 m beyond everything else. model:// URIs are looked for as FindModelFile says. Each model is an
/// object. Left out and counted: other shapes, lights, actors. Missing `sun` and `ground_plane` are
/// skipped, as Gazebo brings them itself; any other error of libsdformat is a FileError.
SceneParts ReadGazeboWorld(const std::filesystem::path& file);

}  // namespace bulletnav::sim
