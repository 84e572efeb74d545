// SPDX-License-Identifier: MIT
#include "benchmark/report/run_tables.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/report/agent_title.h"
#include "benchmark/runs/published.h"
#include "benchmark/runs/result_store.h"
#include "benchmark/runs/runner.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kOurs =
    "Rows in plain type: this run, in its own scenes. Rows marked \"paper, Gibson\": as published "
    "in Neural Topological SLAM, in other scenes; to look at side by side, not to compare number "
    "by number.";

enum class Measure { kSuccess, kSpl, kEuclidean };

/// One column: a figure of the rows of one condition and difficulty.
struct Column {
  std::string condition;
  std::string difficulty;
  Measure measure = Measure::kSuccess;
};

struct TableLayout {
  std::string caption;
  std::vector<ResultsTable::Group> groups;
  std::vector<Column> columns;
};

struct Head {
  std::string difficulty;
  std::string title;
};

std::vector<Head> Difficulties() {
  return {{"easy", "Easy"}, {"medium", "Medium"}, {"hard", "Hard"}, {"overall", "Overall"}};
}

struct ConditionTitle {
  const char* condition;
  const char* title;
  const char* in_caption;
};
constexpr std::array kOthers = {ConditionTitle{"no_stop", "No stop", "without stop action"},
                                ConditionTitle{"no_noise", "No noise", "without motion noise"}};

bool HasCondition(std::span<const SummaryRow> rows, const std::string& condition) {
  return std::any_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
    return row.condition == condition;
  });
}

/// Success and SPL for each of some heads under one condition.
TableLayout SuccessAndSpl(std::string caption, const std::string& condition,
                          std::span<const Head> heads) {
  TableLayout layout;
  layout.caption = std::move(caption);
  for (const Head& head : heads) {
    layout.groups.push_back({head.title, {"Succ", "SPL"}});
    layout.columns.push_back({condition, head.difficulty, Measure::kSuccess});
    layout.columns.push_back({condition, head.difficulty, Measure::kSpl});
  }
  return layout;
}

/// Table 1; stops behind a wall show in its last column.
TableLayout ByDifficulty() {
  TableLayout layout = SuccessAndSpl("Success and SPL by difficulty.", "noise", Difficulties());
  layout.groups.push_back({"Euclidean", {"Succ"}});
  layout.columns.push_back({"noise", "overall", Measure::kEuclidean});
  return layout;
}

/// Table 2, as far as the run has its conditions.
TableLayout SuccessWithoutStopOrNoise(std::span<const SummaryRow> rows) {
  TableLayout layout;
  for (const ConditionTitle& other : kOthers) {
    if (!HasCondition(rows, other.condition)) continue;
    layout.caption +=
        (layout.caption.empty() ? "Success " : " and ") + std::string(other.in_caption);
    layout.groups.push_back({other.title, {}});
    for (const Head& head : Difficulties()) {
      layout.groups.back().columns.push_back(head.title);
      layout.columns.push_back({other.condition, head.difficulty, Measure::kSuccess});
    }
  }
  layout.caption += ".";
  return layout;
}

/// A table for each condition of a run of sequences.
std::vector<TableLayout> ByNumberOfGoals(std::span<const SummaryRow> rows,
                                         std::span<const Head> heads) {
  const std::string caption = "Share of goals reached and SPL by number of sequential goals";
  std::vector<TableLayout> layouts;
  if (HasCondition(rows, "noise")) layouts.push_back(SuccessAndSpl(caption + ".", "noise", heads));
  for (const ConditionTitle& other : kOthers) {
    if (!HasCondition(rows, other.condition)) continue;
    layouts.push_back(
        SuccessAndSpl(caption + ", " + other.in_caption + ".", other.condition, heads));
  }
  return layouts;
}

const SummaryRow* Find(std::span<const SummaryRow> rows, const SummaryRow& like,
                       const Column& column) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const SummaryRow& row) {
    return row.agent == like.agent && row.setting == like.setting &&
           row.condition == column.condition && row.difficulty == column.difficulty;
  });
  return found == rows.end() ? nullptr : &*found;
}

std::string Figure(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "";
}

std::string Figure(const SummaryRow& row, Measure measure) {
  if (measure == Measure::kSpl) return Figure(row.spl);
  return Figure(measure == Measure::kSuccess ? row.success : row.success_euclidean);
}

std::string Figure(const PublishedFigure& known, Measure measure) {
  if (measure == Measure::kEuclidean) return "";  // the paper has none
  return Figure(measure == Measure::kSpl ? known.spl : known.success);
}

std::string SettingTitle(std::string setting) {
  for (char& c : setting) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return setting;
}

std::string Percent95(const Interval& interval) {
  return fmt::format("{:.2f}-{:.2f}", interval.low, interval.high);
}

/// "300 episodes, 95%: 0.78-0.87 / 0.55-0.66, 25.0M frames, oracle": the intervals are of the
/// last column of success and, if there is one, of SPL.
std::string Remark(const TableLayout& layout, std::span<const SummaryRow> rows,
                   const SummaryRow& like) {
  int episodes = 0;
  int failures = 0;
  std::string success;
  std::string spl;
  for (const Column& column : layout.columns) {
    const SummaryRow* row = Find(rows, like, column);
    if (row == nullptr) continue;
    episodes = std::max(episodes, row->episodes);
    failures = std::max(failures, row->failures);
    if (column.measure == Measure::kSuccess) success = Percent95(row->success_ci);
    if (column.measure == Measure::kSpl) spl = " / " + Percent95(row->spl_ci);
  }
  std::string text = Counted(static_cast<std::size_t>(episodes), "episode");
  if (failures > 0) text += fmt::format(", {} of them failed", failures);
  text.append(", 95%: ").append(success).append(spl);
  if (like.frames_trained) {
    text += fmt::format(", {:.1f}M frames", static_cast<double>(*like.frames_trained) / 1e6);
  }
  return like.note.empty() ? text : text + ", " + like.note;
}

/// The paper's row for an agent and setting, if it has one.
void AddPaperRow(const TableLayout& layout, const std::string& agent, const std::string& setting,
                 ResultsTable* table) {
  ResultsTable::Row paper = {
      SettingTitle(setting), AgentTitle(agent, {}) + ", paper, Gibson", true, {}, ""};
  bool any = false;
  for (const Column& column : layout.columns) {
    paper.cells.push_back(
        Figure(FindPublished(agent, setting, column.condition, column.difficulty), column.measure));
    any = any || !paper.cells.back().empty();
  }
  if (any) table->rows.push_back(std::move(paper));
}

/// Our row and the paper's, for the agent and setting of `like`.
void AddRows(const TableLayout& layout, std::span<const SummaryRow> rows, const SummaryRow& like,
             std::span<const AgentRow> agents, ResultsTable* table) {
  ResultsTable::Row ours = {
      SettingTitle(like.setting), AgentTitle(like.agent, agents), false, {}, ""};
  bool any = false;
  for (const Column& column : layout.columns) {
    const SummaryRow* row = Find(rows, like, column);
    ours.cells.push_back(row == nullptr ? "" : Figure(*row, column.measure));
    any = any || row != nullptr;
  }
  if (!any) return;
  ours.remark = Remark(layout, rows, like);
  table->rows.push_back(std::move(ours));
  AddPaperRow(layout, like.agent, like.setting, table);
}

/// The rows of `settings` that the layout has figures for, by setting and then agent.
ResultsTable Fill(const TableLayout& layout, std::span<const SummaryRow> rows,
                  std::span<const AgentRow> agents) {
  ResultsTable table;
  table.caption = layout.caption;
  table.groups = layout.groups;
  std::vector<const SummaryRow*> firsts;  // the first row of each agent and setting
  for (const SummaryRow& row : rows) {
    if (std::none_of(firsts.begin(), firsts.end(), [&](const SummaryRow* first) {
          return first->agent == row.agent && first->setting == row.setting;
        })) {
      firsts.push_back(&row);
    }
  }
  std::stable_sort(firsts.begin(), firsts.end(), [](const SummaryRow* a, const SummaryRow* b) {
    return a->setting < b->setting;
  });
  for (const SummaryRow* first : firsts) AddRows(layout, rows, *first, agents, &table);
  return table;
}

/// Rows for the agents that have no results at all, and the paper's of them.
void AddMissing(const TableLayout& layout, std::span<const SummaryRow> rows,
                std::span<const AgentRow> agents, ResultsTable* table) {
  for (const AgentRow& agent : agents) {
    if (std::any_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
          return row.agent == agent.agent;
        })) {
      continue;
    }
    table->rows.push_back({"", AgentTitle(agent.agent, agents), false,
                           std::vector<std::string>(layout.columns.size()),
                           agent.note.empty() ? "no results" : agent.note});
    for (const char* setting : {"rgb", "rgbd"}) AddPaperRow(layout, agent.agent, setting, table);
  }
}

/// The numbers of goals that sequences were summed over; none for single goals.
std::vector<Head> GoalCounts(std::span<const SummaryRow> rows) {
  std::vector<Head> heads;
  for (int count = 1;; ++count) {
    const std::string name = fmt::format("goals_{}", count);
    if (std::none_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
          return row.difficulty == name;
        })) {
      return heads;
    }
    heads.push_back({name, std::to_string(count)});
  }
}

}  // namespace

std::vector<ResultsTable> MakeTables(std::span<const SummaryRow> rows,
                                     std::span<const AgentRow> agents) {
  const std::vector<Head> goals = GoalCounts(rows);
  const std::vector<TableLayout> layouts =
      goals.empty() ? std::vector{ByDifficulty(), SuccessWithoutStopOrNoise(rows)}
                    : ByNumberOfGoals(rows, goals);
  std::vector<ResultsTable> tables;
  for (const TableLayout& layout : layouts) {
    ResultsTable table = Fill(layout, rows, agents);
    if (table.rows.empty()) continue;
    if (tables.empty()) AddMissing(layout, rows, agents, &table);
    tables.push_back(std::move(table));
  }
  if (tables.empty()) {
    tables.push_back({"No results yet.", {}, {}});
    AddMissing({}, rows, agents, &tables.front());
  }
  return tables;
}

std::string WriteTables(const std::filesystem::path& folder,
                        const std::vector<EpisodeResult>& results,
                        std::span<const AgentRow> agents) {
  const std::vector<SummaryRow> rows = Summarize(results, agents);
  const std::vector<ResultsTable> tables = MakeTables(rows, agents);
  std::string markdown;
  std::string latex;
  for (const ResultsTable& table : tables) {
    markdown += ToMarkdown(table);
    latex += ToLatex(table);
  }
  markdown += std::string(kOurs) + "\n";
  latex += "% " + std::string(kOurs) + "\n";
  sim::WriteFileAtomically(folder / "summary.json", SummaryToJson(rows));
  sim::WriteFileAtomically(folder / "table.csv", SummaryToCsv(rows));
  sim::WriteFileAtomically(folder / "table.tex", latex);
  sim::WriteFileAtomically(folder / "table.md", markdown);
  return markdown;
}

std::string RebuildTables(const std::filesystem::path& folder) {
  const std::vector<AgentRow> agents = AgentRowsOf(LoadSavedRunConfig(folder / "config.yaml"));
  return WriteTables(folder, ReadResults(folder), agents);
}

}  // namespace bulletnav::bench
