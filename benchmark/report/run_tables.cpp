// SPDX-License-Identifier: MIT
#include "benchmark/report/run_tables.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/core.h>

#include "benchmark/evaluation/published.h"
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
  bool is_spl = false;
};

struct Layout {
  std::string caption;
  std::vector<ResultsTable::Group> groups;
  std::vector<Column> columns;
};

struct Head {
  const char* difficulty;
  const char* title;
};
constexpr std::array kHeads = {Head{"easy", "Easy"}, Head{"medium", "Medium"}, Head{"hard", "Hard"},
                               Head{"overall", "Overall"}};

/// Success and SPL for each of some difficulties.
Layout SuccessAndSpl(std::string caption, std::span<const Head> heads) {
  Layout layout;
  layout.caption = std::move(caption);
  for (const Head& head : heads) {
    layout.groups.push_back({head.title, {"Succ", "SPL"}});
    layout.columns.push_back({"noise", head.difficulty, false});
    layout.columns.push_back({"noise", head.difficulty, true});
  }
  return layout;
}

Layout SuccessWithoutStopOrNoise(std::span<const SummaryRow> rows) {
  Layout layout;
  layout.caption = "Success without stop action and without motion noise.";
  const auto add = [&](const char* condition, const char* title) {
    if (std::none_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
          return row.condition == condition;
        })) {
      return;
    }
    layout.groups.push_back({title, {}});
    for (const Head& head : kHeads) {
      layout.groups.back().columns.emplace_back(head.title);
      layout.columns.push_back({condition, head.difficulty, false});
    }
  };
  add("no_stop", "No stop");
  add("no_noise", "No noise");
  return layout;
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

std::string TitleOf(const std::string& agent, std::span<const AgentRow> agents) {
  for (const AgentRow& row : agents) {
    if (row.agent == agent && !row.title.empty()) return row.title;
  }
  const std::string_view published = PublishedTitle(agent);
  return published.empty() ? agent : std::string(published);
}

std::string SettingTitle(std::string setting) {
  for (char& c : setting) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return setting;
}

/// "300 episodes, 25.0M frames, oracle".
std::string Remark(int episodes, int failures, const std::string& agent,
                   std::span<const AgentRow> agents) {
  std::string text = fmt::format("{} episodes", episodes);
  if (failures > 0) text += fmt::format(", {} of them failed", failures);
  for (const AgentRow& row : agents) {
    if (row.agent != agent) continue;
    if (row.frames_trained) {
      text += fmt::format(", {:.1f}M frames", static_cast<double>(*row.frames_trained) / 1e6);
    }
    if (!row.note.empty()) text += ", " + row.note;
  }
  return text;
}

/// Our row and the paper's, for the agent and setting of `like`.
void AddRows(const Layout& layout, std::span<const SummaryRow> rows, const SummaryRow& like,
             std::span<const AgentRow> agents, ResultsTable* table) {
  ResultsTable::Row ours = {SettingTitle(like.setting), TitleOf(like.agent, agents), false, {}, ""};
  ResultsTable::Row paper = {ours.setting, ours.title + ", paper, Gibson", true, {}, ""};
  int episodes = 0;
  int failures = 0;
  bool any_paper = false;
  for (const Column& column : layout.columns) {
    const SummaryRow* row = Find(rows, like, column);
    ours.cells.push_back(row == nullptr ? "" : Figure(column.is_spl ? row->spl : row->success));
    const PublishedFigure known =
        FindPublished(like.agent, like.setting, column.condition, column.difficulty);
    paper.cells.push_back(Figure(column.is_spl ? known.spl : known.success));
    any_paper = any_paper || !paper.cells.back().empty();
    if (row == nullptr) continue;
    episodes = std::max(episodes, row->episodes);
    failures = std::max(failures, row->failures);
  }
  if (episodes == 0) return;
  ours.remark = Remark(episodes, failures, like.agent, agents);
  table->rows.push_back(std::move(ours));
  if (any_paper) table->rows.push_back(std::move(paper));
}

/// The rows of `settings` that the layout has figures for, by setting and then agent.
ResultsTable Fill(const Layout& layout, std::span<const SummaryRow> rows,
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

/// Rows for the agents that have no results at all.
void AddMissing(std::span<const SummaryRow> rows, std::span<const AgentRow> agents,
                ResultsTable* table) {
  std::size_t columns = 0;
  for (const ResultsTable::Group& group : table->groups) columns += group.columns.size();
  for (const AgentRow& agent : agents) {
    if (std::any_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
          return row.agent == agent.agent;
        })) {
      continue;
    }
    table->rows.push_back({"", TitleOf(agent.agent, agents), false,
                           std::vector<std::string>(columns),
                           agent.note.empty() ? "no results" : agent.note});
  }
}

/// The numbers of goals that sequences were summed over, as heads: goals_1, ...
std::vector<std::string> GoalCounts(std::span<const SummaryRow> rows) {
  std::vector<std::string> names;
  for (int count = 1;; ++count) {
    const std::string name = fmt::format("goals_{}", count);
    if (std::none_of(rows.begin(), rows.end(), [&](const SummaryRow& row) {
          return row.difficulty == name;
        })) {
      return names;
    }
    names.push_back(name);
  }
}

}  // namespace

std::vector<ResultsTable> MakeTables(std::span<const SummaryRow> rows,
                                     std::span<const AgentRow> agents) {
  std::vector<ResultsTable> tables;
  const auto add = [&](const Layout& layout) {
    ResultsTable table = Fill(layout, rows, agents);
    if (!table.rows.empty()) tables.push_back(std::move(table));
  };
  const std::vector<std::string> counts = GoalCounts(rows);
  if (counts.empty()) {
    add(SuccessAndSpl("Success and SPL by difficulty.", kHeads));
  } else {
    std::vector<std::string> titles;
    std::vector<Head> heads;
    for (std::size_t i = 0; i < counts.size(); ++i) titles.push_back(std::to_string(i + 1));
    for (std::size_t i = 0; i < counts.size(); ++i) {
      heads.push_back({counts[i].c_str(), titles[i].c_str()});
    }
    add(SuccessAndSpl("Share of goals reached and SPL by number of sequential goals.", heads));
  }
  add(SuccessWithoutStopOrNoise(rows));
  if (tables.empty()) tables.push_back({"No results yet.", {}, {}});
  AddMissing(rows, agents, &tables.front());
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

}  // namespace bulletnav::bench
