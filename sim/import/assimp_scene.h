// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/scene/import.h"

namespace bulletnav::sim {

/// The file, or if not empty `content` in its place, as assimp reads it, in the file's own axes and
/// units, not cleaned: indices are in range, coordinates may be anything. Fills the report's
/// textures and skipped lines. Throws FileError. Every file beside the mesh's own that is read adds
/// to the time allowed.
SceneMesh ReadWithAssimp(const std::filesystem::path& file, std::span<const std::uint8_t> content,
                         ImportReport* report);

}  // namespace bulletnav::sim
