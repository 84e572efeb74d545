// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "benchmark/play/episode_result.h"
#include "benchmark/runs/run_config.h"
#include "benchmark/runs/summary.h"

namespace bulletnav::bench {

/// One result in a page, and which of its blocks there are.
struct ReplayRow {
  EpisodeResult result;
  int scene_block = -1;      // block "sN"; -1: none
  int goal_block = -1;       // block "gN", the goals' panoramas below each other
  std::vector<int> seen;     // steps that block "iROW" has panoramas of, below each other
  bool has_path = false;     // block "eROW": the trajectory's file
  bool has_beliefs = false;  // block "bROW": see BeliefLog
};

/// A run's name: its folder's, with or without a slash at the end.
std::string RunName(const std::filesystem::path& folder);

/// What a page says of the run as a whole.
struct ReplayNotes {
  std::vector<std::string> notes;  // what is missing
  std::string to_play_again;       // what this needs besides the command; mostly empty
};

/// What a page shows first, as JSON: {"name", "folder", "success_distance", "max_steps", "agents":
/// [[name, title]], "scenes": [name], "notes": [text], "to_play_again": text, "columns": [name],
/// "rows": [[value of each column]]}.
std::string RowsJson(const std::filesystem::path& folder, const RunConfig& config,
                     std::span<const AgentRow> agents, std::span<const ReplayRow> rows,
                     const ReplayNotes& notes);

}  // namespace bulletnav::bench
