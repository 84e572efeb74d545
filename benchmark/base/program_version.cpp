// SPDX-License-Identifier: MIT
#include "benchmark/base/program_version.h"

#include <algorithm>
#include <sstream>
#include <system_error>

#include "benchmark/base/git_commit.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kVersionsFile = "versions.txt";

std::string ReadVersions(const std::filesystem::path& folder) {
  std::error_code unreadable;
  if (!std::filesystem::exists(folder / kVersionsFile, unreadable)) return "";
  return sim::ReadTextFile(folder / kVersionsFile);
}

}  // namespace

std::string ProgramVersion() {
  return BULLETNAV_VERSION " (" BULLETNAV_COMMIT ")";
}

std::string CommittedVersion() {
  const std::string version = ProgramVersion();
  return version.find("-dirty") == std::string::npos ? version : "";
}

void NoteVersion(const std::filesystem::path& folder) {
  std::string text = ReadVersions(folder);
  const std::string line = ProgramVersion() + "\n";
  if (text.ends_with(line)) return;
  sim::WriteFileAtomically(folder / kVersionsFile, text.append(line));
}

std::vector<std::string> VersionsOf(const std::filesystem::path& folder) {
  std::istringstream lines(ReadVersions(folder));
  std::vector<std::string> versions;
  for (std::string line; std::getline(lines, line);) {
    if (std::find(versions.begin(), versions.end(), line) == versions.end()) {
      versions.push_back(line);
    }
  }
  return versions;
}

int CountVersions(const std::filesystem::path& folder) {
  return static_cast<int>(VersionsOf(folder).size());
}

}  // namespace bulletnav::bench
