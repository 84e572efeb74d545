// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "sim/import/scene_parts.h"

namespace bulletnav::sim {

/// Whether a file is called *.scene_instance.json.
bool IsHabitatScene(const std::filesystem::path& file);

/// What a scene of habitat-sim consists of: its stage and its objects, each with a template of the
/// data set (see HabitatDataset), translation (metres), rotation (quaternion w, x, y, z) and scale.
/// An object's translation is its centre of mass's, or the middle of its box's where its template
/// has none; with the origin `asset_local`, it is the asset's origin's. Category: the template's
/// name. Articulated objects are URDFs (see ReadUrdf) and stand as `initial_joint_pose` says; their
/// upright revolute joints are doors. Throws FileError.
SceneParts ReadHabitatScene(const std::filesystem::path& file);

}  // namespace bulletnav::sim
