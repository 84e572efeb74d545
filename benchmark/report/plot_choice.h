// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/play/episode_result.h"

namespace bulletnav::bench {

inline constexpr int kFirstPlots = 8;

/// Which episodes of a run are drawn; the first kFirstPlots if nothing is asked for.
struct PlotChoice {
  std::string episode = {};  // only this one
  std::string agent = {};    // only this one's
  int worst = 0;             // only so many, those of least SoftSPL
  bool all = false;

  bool is_default() const { return episode.empty() && agent.empty() && worst == 0 && !all; }
};

/// The results of a run that it has kept trajectories of, in the order of their files' names.
/// Throws sim::FileError as ReadResults does.
std::vector<EpisodeResult> ResultsWithTrajectory(const std::filesystem::path& run);

/// Those of a choice; may be empty. Of the worst, equally bad ones come in turn: one of each row
/// (agent, setting, condition, seed), which go through the scenes in turn; their order in `all`
/// decides last.
std::vector<EpisodeResult> Choose(std::vector<EpisodeResult> all, const PlotChoice& choice);

}  // namespace bulletnav::bench
