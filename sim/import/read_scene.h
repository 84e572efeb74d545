// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "sim/scene/import.h"

namespace bulletnav::sim {

/// What ImportScene promises, in this process: may crash, hang or eat all memory on a damaged file.
ImportedScene ReadScene(const std::filesystem::path& file, const ImportOptions& options);

}  // namespace bulletnav::sim
