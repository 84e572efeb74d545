// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace bulletnav::bench {

/// The config that a user names: where there is no configs/... from the current folder, the one
/// that came with the program (see FindShipped), with a note on standard error.
std::filesystem::path ShippedConfig(const std::filesystem::path& config);

}  // namespace bulletnav::bench
