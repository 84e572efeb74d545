// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/episodes/drawn_grey.h"
#include "benchmark/episodes/episode.h"
#include "benchmark/episodes/made_houses.h"
#include "benchmark/episodes/scene_cache.h"
#include "benchmark/runs/run_config.h"
#include "benchmark/runs/shard.h"

namespace bulletnav::bench {

/// The episodes of a run and where their scenes are.
struct RunEpisodes {
  std::vector<Episode> episodes;
  std::map<std::string, std::filesystem::path> scene_files;  // by the scene's name in episodes
};

/// What the stages of a run work with.
struct RunTools {
  SceneCache& scenes;
  int workers = 0;  // < 1: one per processor
  StartProgress start;
  Warn warn = {};
};

/// Stage "houses": generates those that the config describes and that are not there yet.
void MakeRunHouses(const RunConfig& config, const RunTools& tools);

/// Stage "episodes": draws the file of episodes that the config describes, if it is not there yet;
/// waits while another process does. Returns whether it had to. Throws as GenerateEpisodes.
bool DrawRunEpisodes(const RunConfig& config, const RunTools& tools);
/// Reads the file. Throws sim::Error if it is damaged, was drawn otherwise than the config says, or
/// names scenes that are not there.
RunEpisodes ReadRunEpisodes(const RunConfig& config);

/// Stage "verify": what results depend on, as it is now.
Fingerprints TakeFingerprints(const RunConfig& config, const RunEpisodes& episodes,
                              SceneCache* scenes);
/// Throws sim::Error if the config is a saved one, of other contents. New weights pass.
void CheckFingerprints(const RunConfig& config, const Fingerprints& found);
/// Throws sim::Error for starts and goals where no body can stand, or leaves out those episodes, as
/// the config has it.
void CheckRunEpisodes(const RunConfig& config, const RunTools& tools, RunEpisodes* episodes);

/// What of the episodes a process plays: of so many, if that is given, evenly over scenes and
/// difficulties (those that a smaller number gives are among them), those of a name, if names are
/// given, a share.
struct EpisodeChoice {
  std::optional<int> count;
  std::optional<Shard> shard;
  std::vector<std::string> only = {};
};
/// Throws sim::Error for a name that no episode has.
std::vector<Episode> Choose(std::vector<Episode> episodes, const EpisodeChoice& choice);

/// These stages in turn. Puts the fingerprints into `config`. Returns the episodes of the choice;
/// unless they were drawn here, they have been checked.
RunEpisodes PrepareEpisodes(RunConfig* config, const EpisodeChoice& choice, const RunTools& tools);

}  // namespace bulletnav::bench
