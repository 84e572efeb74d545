// SPDX-License-Identifier: MIT
#include "benchmark/evaluation/program_version.h"

#include <system_error>

#include "benchmark/evaluation/git_commit.h"
#include "sim/base/files.h"

namespace bulletnav::bench {

std::string ProgramVersion() {
  return BULLETNAV_VERSION " (" BULLETNAV_COMMIT ")";
}

void NoteVersion(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "versions.txt";
  std::error_code unreadable;
  std::string text;
  if (std::filesystem::exists(file, unreadable)) text = sim::ReadTextFile(file);
  const std::string line = ProgramVersion() + "\n";
  if (text.ends_with(line)) return;
  sim::WriteFileAtomically(file, text.append(line));
}

}  // namespace bulletnav::bench
