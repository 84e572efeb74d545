// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace bulletnav::bench {

/// sim::Hash64 of a file's content as sixteen hexadecimal digits, to tell whether it has changed.
/// Throws sim::FileError.
std::string FileHash(const std::filesystem::path& file);

}  // namespace bulletnav::bench
