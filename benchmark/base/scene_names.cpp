// SPDX-License-Identifier: MIT
#include "benchmark/base/scene_names.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// Without extension, Habitat's of two words too.
std::string Stem(const fs::path& scene) {
  constexpr std::string_view kInstance = ".scene_instance";
  std::string stem = scene.stem().string();
  if (stem.ends_with(kInstance)) stem.resize(stem.size() - kInstance.size());
  return stem;
}

/// The file without extension, after the last `folders` of the folders that it is in.
std::string NameWith(std::size_t folders, const fs::path& scene) {
  std::string name = Stem(scene);
  fs::path folder = scene.parent_path();
  for (std::size_t i = 0; i < folders; ++i) {
    const std::string one = folder.filename().string();
    if (one.empty() || one == "." || one == "..") return name;
    name = one + "/" + name;
    folder = folder.parent_path();
  }
  return name;
}

}  // namespace

std::map<std::string, std::string> SceneNames(std::span<const std::string> scenes) {
  std::map<std::string, std::string> names;
  std::map<std::string, std::vector<std::string>> alike;  // by name, those that have it
  for (const std::string& scene : scenes) {
    if (names.emplace(scene, "").second) alike[NameWith(0, scene)].push_back(scene);
  }
  for (std::size_t folders = 1; !alike.empty(); ++folders) {
    std::map<std::string, std::vector<std::string>> longer;
    for (const auto& [name, ones] : alike) {
      if (ones.size() == 1) {
        names[ones.front()] = name;
        continue;
      }
      std::map<std::string, std::vector<std::string>> split;
      for (const std::string& scene : ones) split[NameWith(folders, scene)].push_back(scene);
      const bool is_at_end = split.size() == 1 && split.begin()->first == name;
      for (const std::string& scene : ones) {
        if (is_at_end) names[scene] = scene;
      }
      if (!is_at_end) longer.merge(split);
    }
    alike = std::move(longer);
  }
  return names;
}

std::string LongSceneName(const std::string& scene) {
  return NameWith(1, scene);
}

std::string EpisodeName(const std::string& scene, const std::string& episode) {
  const bool has_it = episode.find(Stem(scene)) != std::string::npos;
  return has_it ? episode : LongSceneName(scene) + ", episode " + episode;
}

}  // namespace bulletnav::bench
