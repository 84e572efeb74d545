// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "sim/scene/doors.h"

namespace bulletnav::sim {

/// The doors of a generated house, from the description (.json) beside its mesh: the n-th opening
/// with a leaf is the n-th object of the category `door`. Frame: the house's, metres, y up. Hinges
/// are at the edge about which the leaf swings, at the floor. Absent if there is no description.
/// Throws FileError, naming file, place and remedy, if it is none of a house's.
std::optional<std::vector<DoorLeaf>> ReadHouseDoors(const std::filesystem::path& mesh);

/// Throws FileError if a leaf is not one of the mesh's objects.
void RequireLeaves(const std::filesystem::path& file, const std::vector<DoorLeaf>& doors,
                   const SceneMesh& mesh);

}  // namespace bulletnav::sim
