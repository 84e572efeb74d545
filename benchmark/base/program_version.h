// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace bulletnav::bench {

/// "0.1.0 (3f2a...)": the version and the git commit it was built from, "-dirty" if files differed
/// from it.
std::string ProgramVersion();

/// The same, or empty if files differed from the commit: two such programs may be different.
std::string CommittedVersion();

/// Notes in a folder of results which version plays episodes there: versions.txt, a line for each
/// that did, in order. Throws sim::FileError.
void NoteVersion(const std::filesystem::path& folder);

/// Versions that have played there, each once; none if none was noted. Throws sim::FileError.
std::vector<std::string> VersionsOf(const std::filesystem::path& folder);

/// How many they are.
int CountVersions(const std::filesystem::path& folder);

}  // namespace bulletnav::bench
