// SPDX-License-Identifier: MIT
#include "sim/import/gazebo_files.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string_view>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/import/xml_attributes.h"

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> IfThere(const fs::path& path) {
  std::error_code unreadable;
  return fs::exists(path, unreadable) ? std::optional(path.lexically_normal()) : std::nullopt;
}

/// URIs of a model's includes, as far as its text shows them. Throws FileError for what is no XML.
std::vector<std::string> IncludesOf(const fs::path& file) {
  constexpr std::string_view kStart = "<uri>";
  std::vector<std::string> uris;
  const std::string text = ReadTextFile(file);
  ParseXml(text, file);
  for (std::size_t at = text.find("<include"); at != text.npos; at = text.find("<include", at)) {
    at = text.find(kStart, at);
    if (at == text.npos) break;
    at += kStart.size();
    uris.push_back(text.substr(at, text.find('<', at) - at));
  }
  return uris;
}

/// The SDF files of a model.
std::vector<fs::path> FilesOf(const fs::path& model) {
  std::vector<fs::path> files;
  std::error_code unreadable;
  if (!fs::is_directory(model, unreadable)) return {model};
  for (const fs::directory_entry& entry : fs::directory_iterator(model, unreadable)) {
    if (entry.path().extension() == ".sdf") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Follows the includes of models, depth first.
class IncludeWalk {
 public:
  explicit IncludeWalk(const std::vector<fs::path>& folders) : folders_(folders) {}

  /// Throws FileError where a model includes itself.
  void Follow(const fs::path& model) {
    if (!followed_.insert(model).second) return;
    above_.push_back(model);
    for (const fs::path& file : FilesOf(model)) {
      for (const std::string& uri : IncludesOf(file)) FollowUri(file, uri);
    }
    above_.pop_back();
  }

 private:
  void FollowUri(const fs::path& file, const std::string& uri) {
    const auto included = FindModelFile(folders_, file, uri);
    if (!included) return;
    if (std::find(above_.begin(), above_.end(), *included) != above_.end()) {
      throw FileError(file, "", "includes itself by '" + uri + "'; take the include out");
    }
    Follow(*included);
  }

  const std::vector<fs::path>& folders_;
  std::vector<fs::path> above_;
  std::set<fs::path> followed_;  // a world includes the same models again and again
};

}  // namespace

std::vector<fs::path> ModelFolders(const fs::path& world) {
  std::error_code ignored;
  const fs::path folder = fs::absolute(world, ignored).lexically_normal().parent_path();
  std::vector<fs::path> folders = {folder, folder / "models", folder.parent_path(),
                                   folder.parent_path() / "models"};
  for (const char* name :
       {"GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GAZEBO_MODEL_PATH", "SDF_PATH"}) {
    const char* value = std::getenv(name);
    std::string_view list = value == nullptr ? "" : value;
    while (!list.empty()) {
      const std::string_view one = list.substr(0, list.find(':'));
      if (!one.empty()) folders.emplace_back(one);
      list.remove_prefix(std::min(list.size(), one.size() + 1));
    }
  }
  return folders;
}

std::optional<fs::path> FindModelFile(const std::vector<fs::path>& folders, const fs::path& asker,
                                      const std::string& uri) {
  const std::size_t scheme = uri.find("://");
  if (scheme == std::string::npos) return IfThere(asker.parent_path() / uri);
  const std::string name = uri.substr(0, scheme);
  if (name != "model" && name != "file") return std::nullopt;
  const std::string rest = uri.substr(scheme + 3);
  if (rest.empty()) return std::nullopt;
  if (name == "file") {
    if (auto found = IfThere(asker.parent_path() / rest)) return found;  // also a whole path
  }
  for (const fs::path& folder : folders) {
    if (auto found = IfThere(folder / rest)) return found;
  }
  return std::nullopt;
}

void RequireNoCycle(const std::vector<fs::path>& folders, const fs::path& model) {
  IncludeWalk(folders).Follow(model);
}

}  // namespace bulletnav::sim
