// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/report/trajectory.h"

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

/// A trajectory and the name of its pictures, without extension, below the folder of plots.
struct ChosenTrajectory {
  std::filesystem::path name;
  EpisodeTrajectory trajectory;
};

/// All trajectories that a run has kept, in the order of their files' names. Throws sim::FileError
/// for damaged ones.
std::vector<ChosenTrajectory> ReadTrajectories(const std::filesystem::path& run);

/// Those of a choice; may be empty. Of the worst, equally bad ones come in turn: one of each row
/// (agent, setting, condition, seed), which go through the scenes in turn; files' names decide
/// last.
std::vector<ChosenTrajectory> Choose(std::vector<ChosenTrajectory> all, const PlotChoice& choice);

}  // namespace bulletnav::bench
