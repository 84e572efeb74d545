// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "sim/image/image.h"

namespace bulletnav::sim {

/// 8192 x 8192: what DecodeImage keeps whole.
inline constexpr std::uint64_t kMostKeptPixels = std::uint64_t{1} << 26;

/// DecodeImage, with a picture of more than `most_pixels` halved while it is decoded, as often as
/// it takes: each pixel is the mean of a square of them, sides that do not divide are rounded up.
/// So a scan's texture of 16,384 pixels a side takes the memory of a quarter of it; interlaced PNG,
/// BMP and TGA are held whole for a moment.
Image DecodeImage(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);

/// What a format of textures that DecodeImage does not read is called, by the file's first bytes:
/// those for GPUs, and AVIF. Empty for all others.
std::string_view UnreadFormat(std::span<const std::uint8_t> bytes);
/// The same by the file's name.
std::string_view UnreadFormat(const std::filesystem::path& file);

/// UnreadFormat of KTX files, which are mostly packed as Basis Universal.
inline constexpr std::string_view kKtx = "Basis Universal (KTX2)";

}  // namespace bulletnav::sim
