// SPDX-License-Identifier: MIT
#include "benchmark/report/run_tables.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/play/condition.h"
#include "benchmark/report/agent_title.h"
#include "benchmark/report/scene_table.h"
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

/// One column: a figure of the rows of one condition and difficulty.
struct Column {
  std::string condition;
  std::string difficulty;
  Measure measure;
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

/// The paper's, further ones that there are rows of, and all together.
std::vector<Head> Difficulties(std::span<const SummaryRow> rows) {
  std::vector<Head> heads = {{"easy", "Easy"}, {"medium", "Medium"}, {"hard", "Hard"}};
  for (const Head& further : {Head{"very_hard", "Very hard"}, Head{"extreme", "Extreme"}}) {
    const auto is_of_it = [&](const SummaryRow& row) {
      return row.difficulty == further.difficulty;
    };
    if (std::any_of(rows.begin(), rows.end(), is_of_it)) heads.push_back(further);
  }
  heads.push_back({"overall", "Overall"});
  return heads;
}

struct ConditionTitle {
  const char* title;
  const char* in_caption;
};

ConditionTitle TitleOf(Condition condition) {
  switch (condition) {
    case Condition::kNoise:
      return {"Noise", "with motion noise"};
    case Condition::kNoStop:
      return {"No stop", "without stop action"};
    case Condition::kNoNoise:
      return {"No noise", "without motion noise"};
  }
  return {};
}

bool HasCondition(std::span<const SummaryRow> rows, const std::string& condition) {
  return std::any_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
    return row.condition == condition;
  });
}

/// The measures with columns for each of some heads, under one condition.
TableLayout ForEach(std::span<const Head> heads, const std::string& condition,
                    std::string caption) {
  TableLayout layout;
  layout.caption = std::move(caption);
  for (const Head& head : heads) {
    layout.groups.push_back({head.title, {}});
    for (const Measure& measure : AllMeasures()) {
      if (measure.table_title.empty() || !measure.table_head.empty()) continue;
      layout.groups.back().columns.emplace_back(measure.table_title);
      layout.columns.push_back({condition, head.difficulty, measure});
    }
  }
  return layout;
}

/// Table 1; stops behind a wall show in its last column.
TableLayout ByDifficulty(std::span<const SummaryRow> rows) {
  const std::string condition(sim::NameOf(Condition::kNoise));
  TableLayout layout = ForEach(Difficulties(rows), condition, "Success and SPL by difficulty.");
  for (const Measure& measure : AllMeasures()) {
    if (measure.table_head.empty()) continue;
    layout.groups.push_back({std::string(measure.table_head), {std::string(measure.table_title)}});
    layout.columns.push_back({condition, "overall", measure});
  }
  return layout;
}

/// Table 2, as far as the run has its conditions. SPL, too, if all there is are runs without noise,
/// as those by other benchmarks' rules are.
TableLayout SuccessWithoutStopOrNoise(std::span<const SummaryRow> rows) {
  const std::string exact(sim::NameOf(Condition::kNoNoise));
  if (std::all_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
        return row.condition == exact;
      })) {
    return ForEach(Difficulties(rows), exact,
                   "Success and SPL by difficulty, without motion noise.");
  }
  TableLayout layout;
  for (const auto& [name, condition] : sim::EnumNames<Condition>::kNames) {
    if (condition == Condition::kNoise || !HasCondition(rows, name)) continue;
    const ConditionTitle title = TitleOf(condition);
    layout.caption +=
        (layout.caption.empty() ? "Success " : " and ") + std::string(title.in_caption);
    layout.groups.push_back({title.title, {}});
    for (const Head& head : Difficulties(rows)) {
      layout.groups.back().columns.push_back(head.title);
      layout.columns.push_back({name, head.difficulty, FindMeasure("success")});
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
  for (const auto& [name, condition] : sim::EnumNames<Condition>::kNames) {
    if (!HasCondition(rows, name)) continue;
    const std::string under =
        condition == Condition::kNoise ? "" : std::string(", ") + TitleOf(condition).in_caption;
    layouts.push_back(ForEach(heads, name, caption + under + "."));
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

std::string Percent95(const Interval& interval) {
  return fmt::format("{:.2f}-{:.2f}", interval.low, interval.high);
}

/// Of a measure, in its last column that the rows have.
std::optional<Interval> LastInterval(const TableLayout& layout, std::span<const SummaryRow> rows,
                                     const SummaryRow& like, const Measure& measure) {
  std::optional<Interval> last;
  for (const Column& column : layout.columns) {
    if (column.measure.name != measure.name) continue;
    const SummaryRow* row = Find(rows, like, column);
    if (row != nullptr) last = row->Of(measure.name).interval;
  }
  return last;
}

/// "0.78-0.87 / 0.55-0.66": of each main measure that has a column.
std::string Intervals(const TableLayout& layout, std::span<const SummaryRow> rows,
                      const SummaryRow& like) {
  std::string text;
  for (const Measure& measure : MainMeasures()) {
    const auto interval = LastInterval(layout, rows, like, measure);
    if (interval) text += (text.empty() ? "" : " / ") + Percent95(*interval);
  }
  return text;
}

/// "300 episodes, 95%: 0.78-0.87 / 0.55-0.66, 25.0M frames, oracle".
std::string Remark(const TableLayout& layout, std::span<const SummaryRow> rows,
                   const SummaryRow& like) {
  int episodes = 0;
  int failures = 0;
  for (const Column& column : layout.columns) {
    const SummaryRow* row = Find(rows, like, column);
    if (row == nullptr) continue;
    episodes = std::max(episodes, row->episodes);
    failures = std::max(failures, row->failures);
  }
  std::string text = Counted(static_cast<std::size_t>(episodes), "episode");
  if (failures > 0) text += fmt::format(", {} of them failed", failures);
  text += ", 95%: " + Intervals(layout, rows, like);
  if (like.frames_trained) {
    text += fmt::format(", {:.1f}M frames", static_cast<double>(*like.frames_trained) / 1e6);
  }
  return like.note.empty() ? text : text + ", " + like.note;
}

/// Whether the paper's figures may stand below those of `rows`: bands that were not played have
/// nothing to stand below, and the paper's overall is of its own three.
bool IsLikeThePapers(std::span<const SummaryRow> rows, const std::string& difficulty) {
  if (rows.empty()) return true;
  if (difficulty != "overall") {
    return std::any_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
      return row.difficulty == difficulty;
    });
  }
  static constexpr std::array<std::string_view, 4> kPapers = {"easy", "medium", "hard", "overall"};
  return std::all_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
    return std::find(kPapers.begin(), kPapers.end(), row.difficulty) != kPapers.end();
  });
}

/// The paper's row for an agent and setting, if it has one.
void AddPaperRow(const TableLayout& layout, std::span<const SummaryRow> rows,
                 const std::string& agent, const std::string& setting, ResultsTable* table) {
  ResultsTable::Row paper = {
      SettingTitle(setting), AgentTitle(agent, {}) + ", paper, Gibson", true, {}, ""};
  bool any = false;
  for (const Column& column : layout.columns) {
    const auto published =
        FindPublished(column.measure.name, agent, setting, column.condition, column.difficulty);
    paper.cells.push_back(IsLikeThePapers(rows, column.difficulty) ? Figure(published) : "");
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
    ours.cells.push_back(row == nullptr ? "" : Figure(row->Of(column.measure.name).mean));
    any = any || row != nullptr;
  }
  if (!any) return;
  ours.remark = Remark(layout, rows, like);
  table->rows.push_back(std::move(ours));
  AddPaperRow(layout, rows, like.agent, like.setting, table);
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

/// Rows for the agents that have no results at all, and the paper's of them, unless the run has
/// settings that no paper has.
void AddMissing(const TableLayout& layout, std::span<const SummaryRow> rows,
                std::span<const AgentRow> agents, ResultsTable* table) {
  const bool like_papers =
      rows.empty() || std::any_of(rows.begin(), rows.end(), [](const SummaryRow& row) {
        return row.setting == "rgb" || row.setting == "rgbd";
      });
  for (const AgentRow& agent : agents) {
    if (std::any_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
          return row.agent == agent.agent;
        })) {
      continue;
    }
    table->rows.push_back({"", AgentTitle(agent.agent, agents), false,
                           std::vector<std::string>(layout.columns.size()),
                           agent.note.empty() ? "no results" : agent.note});
    if (!like_papers) continue;
    for (const char* setting : {"rgb", "rgbd"})
      AddPaperRow(layout, rows, agent.agent, setting, table);
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
      goals.empty() ? std::vector{ByDifficulty(rows), SuccessWithoutStopOrNoise(rows)}
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
  if (const auto scenes = SceneTable(results, agents)) {
    const std::string by_scene = ToMarkdown(*scenes);
    sim::WriteFileAtomically(folder / "scenes.md", by_scene);
    markdown += "\n" + by_scene;
  }
  return markdown;
}

std::string RebuildTables(const std::filesystem::path& folder) {
  const std::vector<AgentRow> agents = AgentRowsOf(LoadSavedRunConfig(folder / "config.yaml"));
  return WriteTables(folder, ReadResults(folder), agents);
}

}  // namespace bulletnav::bench
