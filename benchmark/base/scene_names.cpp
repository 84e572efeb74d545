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
    name.insert(0, one + "/");
    folder = folder.parent_path();
  }
  return name;
}

/// Scenes by the name that they have for now.
using Alike = std::map<std::string, std::vector<std::string>>;

Alike Split(const std::vector<std::string>& scenes, std::size_t folders) {
  Alike split;
  for (const std::string& scene : scenes) split[NameWith(folders, scene)].push_back(scene);
  return split;
}

/// Gives their names to scenes that no other is called like or that have no more folders; the
/// others are left, by names with `folders` of these.
Alike NameThoseThatDiffer(const Alike& alike, std::size_t folders,
                          std::map<std::string, std::string>* names) {
  Alike longer;
  for (const auto& [name, ones] : alike) {
    Alike split = Split(ones, folders);
    const bool is_at_end = split.size() == 1 && split.begin()->first == name;
    if (ones.size() > 1 && !is_at_end) {
      longer.merge(split);
      continue;
    }
    for (const std::string& scene : ones) (*names)[scene] = ones.size() == 1 ? name : scene;
  }
  return longer;
}

}  // namespace

std::map<std::string, std::string> SceneNames(std::span<const std::string> scenes) {
  std::map<std::string, std::string> names;
  std::vector<std::string> different;
  for (const std::string& scene : scenes) {
    if (names.emplace(scene, "").second) different.push_back(scene);
  }
  Alike alike = Split(different, 0);
  for (std::size_t folders = 1; !alike.empty(); ++folders) {
    alike = NameThoseThatDiffer(alike, folders, &names);
  }
  return names;
}

std::string LongSceneName(const std::string& scene) {
  return NameWith(1, scene);
}

bool NamesScene(const std::string& scene, const std::string& episode) {
  return episode.find(Stem(scene)) != std::string::npos;
}

std::string EpisodeName(const std::string& scene, const std::string& episode) {
  return NamesScene(scene, episode) ? episode : LongSceneName(scene) + ", episode " + episode;
}

}  // namespace bulletnav::bench
