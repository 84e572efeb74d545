// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/episodes/episode.h"
#include "benchmark/episodes/made_houses.h"
#include "benchmark/runs/run_config.h"

namespace bulletnav::bench {

/// The episodes of a run and where their scenes are.
struct RunEpisodes {
  std::vector<Episode> episodes;
  std::map<std::string, std::filesystem::path> scene_files;  // by the scene's name in episodes
};

/// Reads the episodes of a config, after generating the houses and drawing the episodes that it
/// describes and that are not there yet. Writes fingerprints of what results depend on to
/// `config`, and checks them if it has some. Episodes that were not drawn here are checked against
/// their scenes; `first`: only so many are, and are returned. Throws sim::Error for missing scenes,
/// starts and goals where no body can stand, or other contents than the fingerprints tell.
RunEpisodes PrepareEpisodes(RunConfig* config, std::optional<int> first, int workers,
                            const StartProgress& start);

}  // namespace bulletnav::bench
