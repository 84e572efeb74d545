// SPDX-License-Identifier: MIT
#include "benchmark/base/shipped_file.h"

#include <system_error>

namespace bulletnav::bench {

namespace fs = std::filesystem;

std::optional<fs::path> FindShipped(const fs::path& file) {
  std::error_code unreadable;
  if (fs::exists(file, unreadable)) return file;
  fs::path folder = fs::read_symlink("/proc/self/exe", unreadable);
  while (file.is_relative() && folder.has_relative_path()) {
    folder = folder.parent_path();
    for (const fs::path& below : {fs::path(), fs::path("share/bulletnav")}) {
      fs::path place = folder / below / file;
      if (fs::exists(place, unreadable)) return place;
    }
  }
  return std::nullopt;
}

std::filesystem::path ShippedOr(const std::filesystem::path& file) {
  return FindShipped(file).value_or(file);
}

}  // namespace bulletnav::bench
