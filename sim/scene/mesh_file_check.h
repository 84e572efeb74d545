// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "sim/scene/import.h"

namespace bulletnav::sim {

/// By extension, in any letter case.
bool IsGltfFile(const std::filesystem::path& file);

/// Looks at a mesh file before assimp does, because a damaged file should end in a sentence: format
/// by extension, sizes, and for glTF every length and index in it.
/// Returns which axis is up in that format by convention. Throws FileError.
UpAxis CheckMeshFile(const std::filesystem::path& file);

}  // namespace bulletnav::sim
