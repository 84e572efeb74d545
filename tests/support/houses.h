// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace bulletnav::tests {

/// Writes `count` unfurnished procedural houses house_000.glb, ... and their index.json, in which
/// the first `count - test` are of the split "train" and the others of "test".
void WriteShellHouses(const std::filesystem::path& folder, int count, int test);

}  // namespace bulletnav::tests
