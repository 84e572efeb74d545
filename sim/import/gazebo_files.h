// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bulletnav::sim {

/// Where a world's models may be: its folder, the one above and `models` in both, then what
/// GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH, GAZEBO_MODEL_PATH and SDF_PATH list.
std::vector<std::filesystem::path> ModelFolders(const std::filesystem::path& world);

/// The file or folder that a URI names, if it is there: "model://NAME/REST" or "file://..." below
/// one of `folders`, else a path, relative to the folder of `asker`, the file that has it.
std::optional<std::filesystem::path> FindModelFile(
    const std::vector<std::filesystem::path>& folders, const std::filesystem::path& asker,
    const std::string& uri);

/// Throws FileError where a model in a folder includes itself, in one step or several.
void RequireNoCycle(const std::vector<std::filesystem::path>& folders,
                    const std::filesystem::path& model);

}  // namespace bulletnav::sim
