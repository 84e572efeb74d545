// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "benchmark/base/statistics.h"
#include "benchmark/play/episode_result.h"

namespace bulletnav::bench {

/// An agent of a run, as far as tables speak of it.
struct AgentRow {
  std::string agent;  // as in ResultKey
  std::string title;  // for people; empty: the paper's title, or the agent's name
  /// By setting: panoramas that its functions were trained on, counted as often as they were shown.
  std::map<std::string, std::int64_t> frames_trained;
  std::string note;  // "oracle", "privileged", or why there are no results; may be empty
};

/// What the episodes of a row came to in one measure; empty where they were not measured.
struct Average {
  std::optional<double> mean;
  std::optional<Interval> interval;  // of main measures; see Measure
  std::optional<double> paper;       // on Gibson, of single goals
};

/// Results of one agent under one condition, over the episodes of one difficulty.
struct SummaryRow {
  std::string agent;
  std::string setting;
  std::string condition;
  /// DifficultyName; "overall": all episodes of the row; "goals_3": the first three goals
  /// of sequences.
  std::string difficulty;
  int episodes = 0;
  int failures = 0;  // episodes whose agent was taken off; they count as not solved
  std::map<std::string, Average, std::less<>> averages;  // by measure, of those with a column
  std::optional<std::int64_t> frames_trained;
  std::string note;  // the agent's

  /// An empty one for a measure without a column.
  Average Of(std::string_view measure) const;
};

/// One row for each agent, setting, condition and difficulty that there are results of. Agents come
/// in the order of `agents`, those it leaves out after them by name. Deterministic: the same
/// results, in any order, give the same rows. A measure that one episode of a row lacks is left
/// empty in it.
std::vector<SummaryRow> Summarize(std::vector<EpisodeResult> results,
                                  std::span<const AgentRow> agents);

/// {"rows": [...]}, indented: what the row is of, the columns of its measures, with "_ci" after
/// those that have an interval, frames, the paper's figures and note.
std::string SummaryToJson(std::span<const SummaryRow> rows);
/// A line of names and a line a row, intervals in two columns.
std::string SummaryToCsv(std::span<const SummaryRow> rows);

}  // namespace bulletnav::bench
