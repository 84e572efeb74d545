// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>

namespace bulletnav::bench {

/// Where a file that may have come with the program is, as assets/weights/nts_rgbd.safetensors:
/// `file` itself, if it is there; a relative one else in a folder above the program, as in a
/// checkout, or in share/bulletnav of one, where the program has been installed. Absent if there is
/// no such file.
std::optional<std::filesystem::path> FindShipped(const std::filesystem::path& file);
/// The same, or `file` as it is, so that who reads it says that it is not there.
std::filesystem::path ShippedOr(const std::filesystem::path& file);

}  // namespace bulletnav::bench
