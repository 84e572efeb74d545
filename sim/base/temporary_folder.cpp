// SPDX-License-Identifier: MIT
#include "sim/base/temporary_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "sim/base/error.h"

namespace bulletnav::sim {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "bulletnav_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw sim::FileError(pattern, "", "cannot be made; set TMPDIR to a folder you may write to");
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace bulletnav::sim
