// SPDX-License-Identifier: MIT
#include "benchmark/episodes/drawn_grey.h"

#include <fmt/core.h>

#include "benchmark/base/counted.h"

namespace bulletnav::bench {

std::string DrawnGrey(const std::filesystem::path& scene, const sim::ImportReport& import) {
  std::string what;
  const auto& missing = import.textures_missing;
  if (!missing.empty()) {
    what = fmt::format("{} of {}, as {}", missing.size(),
                       Counted(missing.size() + import.textures_found, "texture"), missing.front());
  }
  for (const std::string& line : import.skipped) {
    if (line.starts_with("material library")) what += (what.empty() ? "" : "; ") + line;
  }
  if (what.empty()) return "";
  return fmt::format("{}: drawn grey: {}; see 'scenes inspect'", scene.string(), what);
}

}  // namespace bulletnav::bench
