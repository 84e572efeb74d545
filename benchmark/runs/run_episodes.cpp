// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_episodes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "benchmark/base/file_hash.h"
#include "benchmark/base/program_version.h"
#include "benchmark/episodes/draw_record.h"
#include "benchmark/episodes/episode_file.h"
#include "benchmark/runs/run_agents.h"
#include "sim/base/error.h"
#include "sim/base/folder_lock.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// Scenes in the order in which they first appear.
std::vector<std::string> ScenesIn(const std::vector<Episode>& episodes) {
  std::vector<std::string> scenes;
  std::map<std::string, bool> seen;
  for (const Episode& episode : episodes) {
    if (seen.try_emplace(episode.scene, true).second) scenes.push_back(episode.scene);
  }
  return scenes;
}

/// Why an episode cannot be played; empty if it can. Throws if that is not to be put up with.
std::string FaultOf(const Episode& episode, const Ground& ground, const RunConfig& config) {
  try {
    CheckEpisode(episode, ground.physics, ground.navmesh, config.body);
    return "";
  } catch (const sim::Error& e) {
    if (config.episodes.skip_unplayable.value_or(false)) return e.what();
    throw sim::FileError(config.episodes.file, "", e.what());
  }
}

/// Those at the places that `is_kept` names, in their order.
template <class IsKept>
void KeepPlaces(const IsKept& is_kept, std::vector<Episode>* episodes) {
  std::vector<Episode> kept;
  for (std::size_t i = 0; i < episodes->size(); ++i) {
    if (is_kept(i)) kept.push_back(std::move((*episodes)[i]));
  }
  *episodes = std::move(kept);
}

/// Leaves out the episodes with a fault, and says so in one line.
void LeaveOut(const std::vector<std::string>& faults, const RunConfig& config, const Warn& warn,
              std::vector<Episode>* episodes) {
  const auto is_fault = [](const std::string& fault) {
    return !fault.empty();
  };
  const auto first = std::find_if(faults.begin(), faults.end(), is_fault);
  if (first == faults.end()) return;
  const auto count = std::count_if(faults.begin(), faults.end(), is_fault);
  if (count == static_cast<std::ptrdiff_t>(faults.size())) {
    throw sim::FileError(config.episodes.file, "",
                         "no episode can be played; if the scenes lie on their side, give "
                         "import: {up: y}, or z. The first: " +
                             *first);
  }
  const auto is_sound = [&](std::size_t i) {
    return faults[i].empty();
  };
  KeepPlaces(is_sound, episodes);
  if (!warn) return;
  warn(fmt::format("{}: {} of {} episodes are left out (skip_unplayable), as {}",
                   config.episodes.file, count, faults.size(), *first));
}

/// Expects a config that says how.
void Draw(const RunConfig& config, const RunTools& tools) {
  const GeneratorSpec spec = config.generator();
  const std::vector<std::string> scenes = ScenesOf(spec);
  WarnOfScenesLeftOut(spec, scenes, tools.warn);
  const auto advance = tools.start("drawing episodes, scenes", static_cast<int>(scenes.size()));
  EpisodeSet set;
  set.episodes = GenerateEpisodes(spec, scenes, tools.workers, advance, &tools.scenes);
  set.other = DrawRecord(spec, scenes);
  WriteEpisodes(spec.out, set);
}

/// The folder that a file is in.
fs::path FolderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// A number for each value, in the order in which they come.
template <class Value>
std::size_t NumberOf(const Value& value, std::map<Value, std::size_t>* numbers) {
  return numbers->try_emplace(value, numbers->size()).first->second;
}

/// Where episodes come in an order every beginning of which is spread over scenes and difficulties:
/// rounds of one episode of each difficulty in each scene, in passes over the scenes, along which
/// the difficulties take turns.
std::vector<std::array<std::size_t, 3>> EvenPlaces(const std::vector<Episode>& episodes) {
  std::map<std::string, std::size_t> scenes;
  std::map<std::optional<Difficulty>, std::size_t> kinds;
  std::vector<std::pair<std::size_t, std::size_t>> cells;
  for (const Episode& episode : episodes) {
    const auto kind = episode.difficulty ? episode.difficulty
                                         : DifficultyAt(episode.goals.front().geodesic_distance);
    cells.emplace_back(NumberOf(episode.scene, &scenes), NumberOf(kind, &kinds));
  }
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> rounds;
  std::vector<std::array<std::size_t, 3>> places;
  for (const auto& cell : cells) {
    const auto [scene, kind] = cell;
    const std::size_t pass = (kind + kinds.size() - scene % kinds.size()) % kinds.size();
    places.push_back({rounds[cell]++, pass, scene});
  }
  return places;
}

/// In the order of the file.
void KeepEvenly(std::size_t count, std::vector<Episode>* episodes) {
  const auto places = EvenPlaces(*episodes);
  auto sorted = places;
  std::sort(sorted.begin(), sorted.end());
  const auto is_early = [&](std::size_t i) {
    return count > 0 && places[i] <= sorted[count - 1];
  };
  KeepPlaces(is_early, episodes);
}

void KeepOnly(const std::vector<std::string>& names, std::vector<Episode>* episodes) {
  if (names.empty()) return;
  for (const std::string& name : names) {
    const auto is_it = [&](const Episode& episode) {
      return episode.id == name;
    };
    if (std::any_of(episodes->begin(), episodes->end(), is_it)) continue;
    throw sim::Error(fmt::format("there is no episode '{}'; see episodes.jsonl of a run", name));
  }
  std::erase_if(*episodes, [&](const Episode& episode) {
    return std::find(names.begin(), names.end(), episode.id) == names.end();
  });
}

}  // namespace

void MakeRunHouses(const RunConfig& config, const RunTools& tools) {
  if (config.houses) MakeHouses(*config.houses, CommittedVersion(), tools.workers, tools.start);
}

bool DrawRunEpisodes(const RunConfig& config, const RunTools& tools) {
  const fs::path file = config.episodes.file;
  while (config.episodes.draw && !fs::exists(file)) {
    try {
      const sim::FolderLock lock(FolderOf(file));
      if (fs::exists(file)) return false;  // another process was quicker
      Draw(config, tools);
      return true;
    } catch (const sim::FolderBusy&) {
      const auto advance = tools.start("waiting for a process that draws the episodes, files", 1);
      sim::WaitForFolder(FolderOf(file));
      advance();
    }
  }
  return false;
}

RunEpisodes ReadRunEpisodes(const RunConfig& config) {
  RunEpisodes all;
  if (!config.episodes.draw && !fs::exists(config.episodes.file)) {
    throw sim::FileError(config.episodes.file, "",
                         "is not there, and the config draws none ('draw'); episodes that others "
                         "publish come from where the first lines of their config say");
  }
  EpisodeSet set = ReadEpisodes(config.episodes.file);
  if (config.episodes.draw) RequireDrawnFrom(set, config.generator(), config.episodes.file);
  all.episodes = std::move(set.episodes);
  const std::vector<fs::path> folders(config.episodes.scene_folders.begin(),
                                      config.episodes.scene_folders.end());
  for (const std::string& scene : ScenesIn(all.episodes)) {
    all.scene_files[scene] = FindScene(scene, folders);
  }
  return all;
}

Fingerprints TakeFingerprints(const RunConfig& config, const RunEpisodes& episodes,
                              SceneCache* scenes) {
  Fingerprints fingerprints;
  fingerprints.episodes = FileHash(config.episodes.file);
  for (const auto& [scene, file] : episodes.scene_files) {
    fingerprints.scenes[scene] = scenes->HashOf(file);
  }
  for (const auto& [key, file] : UsedWeights(config)) {
    fingerprints.weights[key] = FileHash(file);
  }
  return fingerprints;
}

void CheckFingerprints(const RunConfig& config, const Fingerprints& found) {
  if (!config.fingerprints || *config.fingerprints == found) return;
  if (config.fingerprints->episodes != found.episodes) {
    throw sim::FileError(config.episodes.file, "",
                         "is not the file that this saved config is of; bring that "
                         "back, or play by the version in versions.txt beside the config");
  }
  for (const auto& [scene, hash] : found.scenes) {
    const auto saved = config.fingerprints->scenes.find(scene);
    if (saved != config.fingerprints->scenes.end() && saved->second == hash) continue;
    throw sim::FileError(scene, "", "is not the scene that this saved config is of");
  }
  if (config.fingerprints->scenes != found.scenes) {
    throw sim::Error("the saved config is of other scenes than its episodes now name");
  }
  // Weights that were not there then are welcome: agents that need them have not run.
  for (const auto& [key, hash] : config.fingerprints->weights) {
    const auto now = found.weights.find(key);
    if (now != found.weights.end() && now->second == hash) continue;
    throw sim::Error("the weights for " + key +
                     " are not those that this saved config is of; give --out another folder");
  }
}

void CheckRunEpisodes(const RunConfig& config, const RunTools& tools, RunEpisodes* episodes) {
  const std::vector<std::string> scenes = ScenesIn(episodes->episodes);
  const auto advance = tools.start("checking episodes, scenes", static_cast<int>(scenes.size()));
  std::vector<std::string> faults(episodes->episodes.size());
  sim::WorkerPool pool(tools.workers);
  pool.ForEach(static_cast<int>(scenes.size()), [&](int task, int /*worker*/) {
    const std::string& scene = scenes[static_cast<std::size_t>(task)];
    const auto ground = tools.scenes.LoadGround(episodes->scene_files.at(scene));
    for (std::size_t i = 0; i < faults.size(); ++i) {
      const Episode& episode = episodes->episodes[i];
      if (episode.scene == scene) faults[i] = FaultOf(episode, *ground, config);
    }
    advance();
  });
  LeaveOut(faults, config, tools.warn, &episodes->episodes);
}

std::vector<Episode> Choose(std::vector<Episode> episodes, const EpisodeChoice& choice) {
  const auto count = static_cast<std::size_t>(choice.count.value_or(0));
  if (choice.count && count < episodes.size()) KeepEvenly(count, &episodes);
  KeepOnly(choice.only, &episodes);
  return choice.shard ? ShareOf(episodes, *choice.shard) : episodes;
}

RunEpisodes PrepareEpisodes(RunConfig* config, const EpisodeChoice& choice, const RunTools& tools) {
  MakeRunHouses(*config, tools);
  const bool drawn = DrawRunEpisodes(*config, tools);
  RunEpisodes episodes = ReadRunEpisodes(*config);
  const Fingerprints found = TakeFingerprints(*config, episodes, &tools.scenes);
  CheckFingerprints(*config, found);
  config->fingerprints = found;
  episodes.episodes = Choose(std::move(episodes.episodes), choice);
  if (!drawn) CheckRunEpisodes(*config, tools, &episodes);
  return episodes;
}

}  // namespace bulletnav::bench
