// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "sim/import/scene_parts.h"
#include "sim/scene/import.h"

namespace bulletnav::sim {

/// What ImportScene promises, in this process: may crash, hang or eat all memory on a damaged file.
ImportedScene ReadScene(const std::filesystem::path& file, const ImportOptions& options);

/// The same where the file has been read into parts.
ImportedScene ReadScene(const std::filesystem::path& file, const SceneParts& parts,
                        const ImportOptions& options);

}  // namespace bulletnav::sim
