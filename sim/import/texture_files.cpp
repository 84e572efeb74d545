// SPDX-License-Identifier: MIT
#include "sim/import/texture_files.h"

#include <algorithm>
#include <array>

#include "sim/base/lower_case.h"
#include "sim/import/uri.h"

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::optional<fs::path> FindIgnoringCase(const fs::path& folder, const std::string& file_name) {
  const std::string lower = LowerCase(file_name);
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (LowerCase(entry.path().filename().string()) == lower) return entry.path();
  }
  return std::nullopt;
}

}  // namespace

std::optional<fs::path> FindTextureFile(const fs::path& mesh_file, const std::string& name) {
  if (name.empty() || name.size() > 4096 || name.find('\0') != std::string::npos) {
    return std::nullopt;
  }
  std::string forward = DecodePercents(name);
  std::replace(forward.begin(), forward.end(), '\\', '/');
  const fs::path folder = mesh_file.has_parent_path() ? mesh_file.parent_path() : ".";
  const fs::path relative(forward);
  if (IsFile(folder / relative)) return folder / relative;  // also an absolute path that exists
  const std::string base = relative.filename().string();
  if (base.empty()) return std::nullopt;
  for (const char* sub : std::array{"", "textures", "texture", "tex", "images", "materials",
                                    "../materials/textures"}) {  // the last: Gazebo's models
    const fs::path place = folder / sub;
    if (IsFile(place / base)) return place / base;
    if (auto found = FindIgnoringCase(place, base); found && IsFile(*found)) return found;
  }
  return std::nullopt;
}

}  // namespace bulletnav::sim
