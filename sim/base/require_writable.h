// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace bulletnav::sim {

/// Whether WriteFileAtomically could write a file now, to be told before long work: makes missing
/// parent folders and, for a moment, a temporary file. Throws FileError as it would.
void RequireWritable(const std::filesystem::path& file);

}  // namespace bulletnav::sim
