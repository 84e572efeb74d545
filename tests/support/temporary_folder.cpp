// SPDX-License-Identifier: MIT
#include "tests/support/temporary_folder.h"

#include <fstream>

namespace bulletnav::tests {

std::filesystem::path TemporaryFolder::Write(std::string_view name,
                                             std::string_view content) const {
  const std::filesystem::path file = path() / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

}  // namespace bulletnav::tests
