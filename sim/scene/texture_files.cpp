// SPDX-License-Identifier: MIT
#include "sim/scene/texture_files.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// "my%20wood.png" -> "my wood.png".
std::string DecodePercents(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = i + 2 < text.size() ? HexDigit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? HexDigit(text[i + 2]) : -1;
    if (text[i] == '%' && high >= 0 && low >= 0) {
      out += static_cast<char>(16 * high + low);
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

bool SameIgnoringCase(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

std::optional<fs::path> FindIgnoringCase(const fs::path& folder, const std::string& file_name) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (SameIgnoringCase(entry.path().filename().string(), file_name)) return entry.path();
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
  const fs::path folder = mesh_file.parent_path();
  const fs::path relative(forward);
  if (IsFile(folder / relative)) return folder / relative;  // also an absolute path that exists
  const std::string base = relative.filename().string();
  if (base.empty()) return std::nullopt;
  for (const char* sub : std::array{"", "textures", "texture", "tex", "images", "materials"}) {
    const fs::path place = folder / sub;
    if (IsFile(place / base)) return place / base;
    if (const auto found = FindIgnoringCase(place, base); found && IsFile(*found)) return found;
  }
  return std::nullopt;
}

}  // namespace bulletnav::sim
