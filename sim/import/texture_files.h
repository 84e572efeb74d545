// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace bulletnav::sim {

/// Where the picture that a mesh file calls `name` really is: beside the mesh, with backslashes,
/// percent codes, absolute paths of somebody's machine and letter case forgiven.
std::optional<std::filesystem::path> FindTextureFile(const std::filesystem::path& mesh_file,
                                                     const std::string& name);

}  // namespace bulletnav::sim
