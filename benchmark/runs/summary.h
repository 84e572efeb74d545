// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/play/episode_result.h"
#include "benchmark/runs/statistics.h"

namespace bulletnav::bench {

/// An agent of a run, as far as tables speak of it.
struct AgentRow {
  std::string agent;  // as in ResultKey
  std::string title;  // for people; empty: the paper's title, or the agent's name
  /// By setting: panoramas that its functions were trained on, counted as often as they were shown.
  std::map<std::string, std::int64_t> frames_trained;
  std::string note;  // "oracle", "privileged", or why there are no results; may be empty
};

/// Results of one agent under one condition, over the episodes of one difficulty.
struct SummaryRow {
  std::string agent;
  std::string setting;
  std::string condition;
  /// "easy", "medium", "hard"; "overall": all episodes of the row; "goals_3": the first three goals
  /// of sequences.
  std::string difficulty;
  int episodes = 0;
  int failures = 0;      // episodes whose agent was taken off; they count as not solved
  double success = 0.0;  // of goals reached
  Interval success_ci;   // Wilson; of sequences, bootstrapped over episodes
  double success_euclidean = 0.0;
  double spl = 0.0;
  Interval spl_ci;  // bootstrapped over episodes
  double soft_spl = 0.0;
  double distance_to_goal_mean = 0.0;  // metres at the end; straight where no way leads there
  double steps_mean = 0.0;
  double collisions_mean = 0.0;
  std::optional<std::int64_t> frames_trained;
  std::optional<double> paper_success;  // on Gibson, of single goals
  std::optional<double> paper_spl;
  std::string note;  // the agent's
};

/// One row for each agent, setting, condition and difficulty that there are results of. Agents come
/// in the order of `agents`, those it leaves out after them by name. Deterministic: the same
/// results, in any order, give the same rows. An episode of several goals counts with their mean;
/// steps and collisions with their sum.
std::vector<SummaryRow> Summarize(std::vector<EpisodeResult> results,
                                  std::span<const AgentRow> agents);

/// {"rows": [...]}, indented; keys are the members' names, `failures` left out.
std::string SummaryToJson(std::span<const SummaryRow> rows);
/// A line of names and a line a row, intervals in two columns.
std::string SummaryToCsv(std::span<const SummaryRow> rows);

}  // namespace bulletnav::bench
