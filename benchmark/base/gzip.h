// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bulletnav::bench {

/// Whether the bytes begin like a gzip file.
bool IsGzip(std::span<const std::uint8_t> bytes);

/// Text as a gzip file: the same text gives the same bytes on every day and machine.
std::vector<std::uint8_t> Compress(std::string_view text);

/// Text of a gzip file of one or more members. Throws sim::Error, naming the remedy, for a file
/// that is cut off, damaged, or larger than 2 GiB unpacked. Source: zlib.
std::string Decompress(std::span<const std::uint8_t> bytes);

}  // namespace bulletnav::bench
