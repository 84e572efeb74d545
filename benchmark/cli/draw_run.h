// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "benchmark/report/plot_choice.h"

namespace bulletnav::bench {

struct DrawOptions {
  std::filesystem::path run = {};
  std::filesystem::path out = {};  // RUN/plots if empty
  PlotChoice choice = {};
  bool belief = false;   // add the agent's own map or graph
  bool film = false;     // add filmstrips
  bool animate = false;  // add moving pictures
};

struct DrawnCount {
  std::size_t episodes = 0;
  std::size_t charts = 0;
};

/// "3 episodes and 1 chart".
std::string ToText(const DrawnCount& drawn);

/// The folder that pictures go to.
std::filesystem::path PlotFolder(const DrawOptions& options);

/// Draws episodes of a run and the charts of its results, with progress on standard error. Of a run
/// that kept no trajectories only the charts. Throws sim::Error, also if no episode is of the
/// choice or a scene has changed since the run.
DrawnCount DrawRun(const DrawOptions& options);

}  // namespace bulletnav::bench
