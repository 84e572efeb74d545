// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace bulletnav::bench {

/// Throws sim::FileError if the file of a scene is not the one that a run was made in. `hashes`: of
/// scenes' contents by name, as in the `fingerprints` of the run's config.yaml; scenes that it does
/// not name pass.
void RequireSceneOfRun(const std::filesystem::path& file, const std::string& scene,
                       const std::map<std::string, std::string>& hashes);

}  // namespace bulletnav::bench
