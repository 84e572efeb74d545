// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

namespace bulletnav::sim {

/// Checks a .ply file's header, and that the file is long enough for the elements it announces: a
/// damaged count keeps readers busy for hours. Throws FileError at the header's line.
/// Source: G. Turk, "The PLY Polygon File Format".
void CheckPly(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

}  // namespace bulletnav::sim
