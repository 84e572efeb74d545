// SPDX-License-Identifier: MIT
#include "benchmark/episodes/generator.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>
#include <string_view>

#include <fmt/core.h>

#include "benchmark/base/json_cursor.h"
#include "benchmark/base/scene_names.h"
#include "benchmark/episodes/episode_drawer.h"
#include "benchmark/episodes/scene_cache.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/lower_case.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using sim::Error;

constexpr std::size_t kKinds = kDifficulties.size() + 1;  // and sequential

std::array<int, kKinds> Counts(const EpisodeCounts& counts) {
  return {counts.easy,
          counts.medium,
          counts.hard,
          counts.very_hard.value_or(0),
          counts.extreme.value_or(0),
          counts.sequential};
}

/// How many of each kind the scene with number s of n gets. What is left over goes to the first
/// scenes; of kinds with fewer episodes than scenes it goes on where the one before ended.
std::array<int, kKinds> SharesOf(const EpisodeCounts& counts, std::size_t s, std::size_t n) {
  std::array<int, kKinds> shares = Counts(counts);
  const auto scene = static_cast<int>(s);
  const auto scenes = static_cast<int>(n);
  int first = 0;
  for (int& share : shares) {
    const int count = share;
    if (count >= scenes) {
      share = count / scenes + (scene < count % scenes ? 1 : 0);
      continue;
    }
    share = (scene + scenes - first) % scenes < count ? 1 : 0;
    first = (first + count) % scenes;
  }
  return shares;
}

/// The beginnings of the episodes' ids, by scene.
std::vector<std::string> Labels(const std::vector<std::string>& scenes) {
  const std::map<std::string, std::string> names = SceneNames(scenes);
  std::vector<std::string> labels;
  for (const std::string& scene : scenes) {
    std::string label = names.at(scene);
    std::replace(label.begin(), label.end(), '/', '-');
    const bool is_new = std::find(labels.begin(), labels.end(), label) == labels.end();
    labels.push_back(std::move(label));
    if (is_new) continue;
    throw sim::FileError(scene, "",
                         "another scene's episodes would be called '" + labels.back() +
                             "' as well; name each scene once, or rename one");
  }
  return labels;
}

/// Whether a mesh is another form of a scan that lies beside it: labels instead of colours, or
/// textures that are not read.
bool IsOtherForm(const fs::path& mesh) {
  const std::string name = mesh.filename().string();
  if (name.ends_with(".semantic.glb") || name.ends_with("_semantic.ply")) return true;
  constexpr std::string_view kBasis = ".basis.glb";
  if (!name.ends_with(kBasis)) return false;
  const std::string plain = name.substr(0, name.size() - kBasis.size()) + ".glb";
  return fs::exists(mesh.parent_path() / plain);
}

bool IsSceneInstance(const std::string& file) {
  return file.ends_with(".scene_instance.json");
}

/// The folder at or above a scene instance that has its data set's config; empty if none has.
fs::path DatasetOf(const fs::path& scene) {
  std::error_code unreadable;
  for (fs::path folder = scene.parent_path(); !folder.empty(); folder = folder.parent_path()) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable)) {
      if (entry.path().string().ends_with(".scene_dataset_config.json")) return folder;
    }
    if (folder == folder.parent_path()) break;
  }
  return {};
}

/// Meshes of a data set whose scenes are made of several are parts, not scenes.
void EraseParts(std::vector<std::string>* scenes) {
  std::set<std::string> folders;
  for (const std::string& scene : *scenes) {
    if (!IsSceneInstance(scene)) continue;
    const fs::path folder = DatasetOf(scene);
    if (!folder.empty()) folders.insert((folder / "").string());
  }
  std::erase_if(*scenes, [&](const std::string& scene) {
    return !IsSceneInstance(scene) &&
           std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
             return scene.starts_with(folder);
           });
  });
}

constexpr const char* kPutSome =
    "; put meshes (.glb, .gltf, .obj, .ply, .dae) or a link to them there, or name another folder "
    "with the key 'scenes' (of a run: episodes.draw.scenes=[FOLDER])";

/// Whether a link to a folder leads back to a folder that holds it.
bool LeadsBack(const fs::path& link) {
  std::error_code ignored;  // what cannot be followed is not gone into either
  const fs::path target = fs::canonical(link, ignored);
  const fs::path holder = fs::canonical(link.parent_path(), ignored);
  return std::mismatch(target.begin(), target.end(), holder.begin(), holder.end()).first ==
         target.end();
}

/// In the order of their names.
std::vector<std::string> MeshesBelow(const fs::path& folder) {
  constexpr std::array<std::string_view, 5> kMeshes = {".glb", ".gltf", ".obj", ".ply", ".dae"};
  std::vector<std::string> meshes;
  const auto options = fs::directory_options::follow_directory_symlink |
                       fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, options), end; at != end; ++at) {
    const fs::directory_entry& entry = *at;
    if (entry.is_symlink() && entry.is_directory() && LeadsBack(entry.path())) {
      at.disable_recursion_pending();
      continue;
    }
    const std::string extension = sim::LowerCase(entry.path().extension().string());
    const bool is_mesh = std::find(kMeshes.begin(), kMeshes.end(), extension) != kMeshes.end();
    if (!is_mesh && !IsSceneInstance(entry.path().string())) continue;
    if (IsOtherForm(entry.path())) continue;
    meshes.push_back(entry.path().string());
  }
  if (meshes.empty()) {
    throw sim::FileError(folder, "", std::string("holds no mesh") + kPutSome);
  }
  EraseParts(&meshes);
  std::sort(meshes.begin(), meshes.end());
  return meshes;
}

using EpisodesByKind = std::array<std::vector<Episode>, kKinds>;

EpisodesByKind DrawScene(EpisodeDrawer* drawer, const GeneratorSpec& spec,
                         const std::array<int, kKinds>& counts) {
  EpisodesByKind drawn;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    for (int i = 0; i < counts[kind]; ++i) {
      drawn[kind].push_back(kind < kDifficulties.size()
                                ? drawer->Draw(kDifficulties[kind], i)
                                : drawer->DrawSequence(spec.sequential_goals, i));
    }
  }
  return drawn;
}

std::vector<Episode> Interleave(const std::vector<EpisodesByKind>& scenes) {
  // Sorting by (index, kind, scene) is the interleaving.
  std::vector<std::array<std::size_t, 3>> places;
  for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      const std::size_t count = scenes[scene][kind].size();
      for (std::size_t i = 0; i < count; ++i) places.push_back({i, kind, scene});
    }
  }
  std::sort(places.begin(), places.end());
  std::vector<Episode> all;
  all.reserve(places.size());
  for (const auto& [index, kind, scene] : places) all.push_back(scenes[scene][kind][index]);
  return all;
}

}  // namespace

void EpisodeCounts::Validate() const {
  const auto counts = Counts(*this);
  if (std::any_of(counts.begin(), counts.end(), [](int count) {
        return count < 0 || count > 1'000'000;
      })) {
    throw Error("each count must lie between 0 and 1000000");
  }
}

void GeneratorSpec::Validate() const {
  const auto sum = Counts(counts);
  if (std::count(sum.begin(), sum.end(), 0) == static_cast<int>(kKinds)) {
    throw Error("'counts' asks for no episodes");
  }
  if (scenes.empty() && !houses) throw Error("names no scenes; give 'scenes' or 'houses'");
  if (sequential_goals < 1 || sequential_goals > 1000) {
    throw Error("sequential_goals must lie between 1 and 1000");
  }
  if (out.empty()) throw Error("'out' is empty; name the file to write");
}

namespace {

/// The meshes of a folder, or a file itself.
std::vector<std::string> ScenesAt(const std::string& place) {
  if (fs::is_directory(place)) return MeshesBelow(place);
  if (!fs::exists(place) && !fs::path(place).has_extension()) {
    throw sim::FileError(place, "", std::string("there is no such folder") + kPutSome);
  }
  return {place};
}

}  // namespace

std::vector<std::string> ScenesOf(const GeneratorSpec& spec) {
  std::vector<std::string> scenes;
  for (const std::string& place : spec.scenes) {
    const std::vector<std::string> those = ScenesAt(place);
    scenes.insert(scenes.end(), those.begin(), those.end());
  }
  if (!spec.houses) return scenes;
  const fs::path file = spec.houses->index;
  if (!fs::exists(file)) {
    throw sim::FileError(file, "", "does not exist; generate the houses first");
  }
  const Json json = ParseJson(sim::ReadTextFile(file), file);
  const JsonCursor houses = JsonCursor(json, file, "").At("houses");
  const std::size_t before = scenes.size();
  for (std::size_t i = 0; i < houses.Size(); ++i) {
    const JsonCursor house = houses.Item(i);
    if (house.At("split").Text() != spec.houses->split) continue;
    scenes.push_back((file.parent_path() / house.At("file").Text()).string());
  }
  if (scenes.size() == before) {
    houses.Fail("has no house of the split '" + spec.houses->split +
                "'; sets of eleven houses or more have all three");
  }
  return scenes;
}

void WarnOfScenesLeftOut(const GeneratorSpec& spec, const std::vector<std::string>& scenes,
                         const Warn& warn) {
  const auto counts = Counts(spec.counts);
  const auto sum = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (!warn || sum >= scenes.size()) return;
  warn(
      fmt::format("{}: {} scenes share {} episodes, so that some have none; ask for more in "
                  "'counts' (of a run: episodes.draw.counts)",
                  spec.out, scenes.size(), sum));
}

std::vector<Episode> GenerateEpisodes(const GeneratorSpec& spec,
                                      const std::vector<std::string>& scenes, int workers,
                                      const std::function<void()>& on_scene, SceneCache* cache) {
  SceneCache own({spec.import.options(), spec.navmesh}, 0);
  SceneCache& loaded = cache == nullptr ? own : *cache;
  const std::vector<std::string> labels = Labels(scenes);
  std::vector<EpisodesByKind> drawn(scenes.size());
  sim::WorkerPool pool(workers);
  pool.ForEach(static_cast<int>(scenes.size()), [&](int task, int /*worker*/) {
    const auto s = static_cast<std::size_t>(task);
    const auto ground = loaded.LoadGround(scenes[s]);
    EpisodeDrawer drawer(*ground, scenes[s], labels[s], spec.body, spec.seed);
    drawn[s] = DrawScene(&drawer, spec, SharesOf(spec.counts, s, scenes.size()));
    if (on_scene) on_scene();
  });
  return Interleave(drawn);
}

}  // namespace bulletnav::bench
