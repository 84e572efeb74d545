// SPDX-License-Identifier: MIT
#include "benchmark/report/result_charts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <tuple>

#include <fmt/core.h>

#include "benchmark/report/agent_title.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kBootstrapSeed = 0;
constexpr std::size_t kLeastEpisodes = 5;  // of a bin

/// What a line of a chart stands for; ordered like the agents of the run.
struct LineKey {
  std::size_t place = 0;
  std::string agent;
  std::string setting;
  std::string condition;

  auto Order() const { return std::tie(place, agent, setting, condition); }
  bool operator<(const LineKey& other) const { return Order() < other.Order(); }
};

template <class Row>
LineKey KeyOf(const Row& row, std::span<const AgentRow> agents) {
  LineKey key = {0, row.agent, row.setting, row.condition};
  while (key.place < agents.size() && agents[key.place].agent != row.agent) ++key.place;
  return key;
}

std::string NameOf(const LineKey& key, std::span<const AgentRow> agents) {
  std::string note;
  if (key.place < agents.size() && !agents[key.place].note.empty()) {
    note = ", " + agents[key.place].note;
  }
  return fmt::format("{} ({}, {}{})", AgentTitle(key.agent, agents), key.setting, key.condition,
                     note);
}

/// One of each main measure, with nothing in them yet.
std::vector<Chart> EmptyCharts(const std::string& x_label) {
  std::vector<Chart> charts;
  for (const Measure& measure : MainMeasures()) {
    charts.push_back({x_label, std::string(measure.label), {}});
  }
  return charts;
}

using Bin = std::vector<const GoalMetrics*>;

/// A mean with its interval, if there is something to take it of; the same for the same goals in
/// any order.
std::optional<Chart::Value> ValueAt(double x, const Bin& bin, const Measure& measure) {
  std::vector<double> values;
  for (const GoalMetrics* goal : bin) {
    if (const auto value = EpisodeValue(measure, {goal, 1})) values.push_back(*value);
  }
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const bool is_share = measure.kind == MeasureKind::kYesNo;
  return Chart::Value{x, Mean(values),
                      is_share ? ShareInterval(values) : BootstrapInterval(values, kBootstrapSeed)};
}

using Bins = std::map<int, Bin>;  // by the metre they begin at

Bins Filled(const Bins& bins) {
  Bins filled;
  for (const auto& [metre, bin] : bins) {
    if (bin.size() >= kLeastEpisodes) filled[metre] = bin;
  }
  return filled;
}

using GoalCounts = std::map<int, const SummaryRow*>;

std::vector<Chart::Value> ValuesOf(const GoalCounts& counts, const Measure& measure) {
  std::vector<Chart::Value> values;
  for (const auto& [goals, row] : counts) {
    const Average average = row->Of(measure.name);
    if (!average.mean || !average.interval) continue;
    values.push_back({static_cast<double>(goals), *average.mean, *average.interval});
  }
  return values;
}

std::vector<Chart::Value> ValuesOf(const Bins& bins, const Measure& measure) {
  std::vector<Chart::Value> values;
  for (const auto& [metre, bin] : bins) {
    if (const auto value = ValueAt(metre + 0.5, bin, measure)) values.push_back(*value);
  }
  return values;
}

/// A series for `line` in the chart of each main measure.
template <class Line>
void AddSeries(const std::string& name, const Line& line, std::vector<Chart>* charts) {
  const std::vector<Measure> measures = MainMeasures();
  for (std::size_t i = 0; i < measures.size(); ++i) {
    (*charts)[i].series.push_back({name, ValuesOf(line, measures[i])});
  }
}

}  // namespace

std::vector<Chart> GoalCountCharts(std::span<const SummaryRow> rows,
                                   std::span<const AgentRow> agents) {
  std::map<LineKey, GoalCounts> lines;
  for (const SummaryRow& row : rows) {
    int goals = 0;
    if (std::sscanf(row.difficulty.c_str(), "goals_%9d", &goals) != 1) continue;
    lines[KeyOf(row, agents)][goals] = &row;
  }
  if (lines.empty()) return {};
  std::vector<Chart> charts = EmptyCharts("number of goals");
  for (const auto& [key, line] : lines) AddSeries(NameOf(key, agents), line, &charts);
  return charts;
}

std::vector<Chart> DistanceCharts(std::span<const EpisodeResult> results,
                                  std::span<const AgentRow> agents) {
  std::map<LineKey, Bins> lines;
  for (const EpisodeResult& result : results) {
    if (result.goals.size() != 1) continue;
    const GoalMetrics& goal = result.goals.front();
    const auto metre = static_cast<int>(std::floor(goal.Value("start_distance")));
    lines[KeyOf(result.key, agents)][metre].push_back(&goal);
  }
  std::vector<Chart> charts = EmptyCharts("geodesic distance to the goal (m)");
  bool left_out = false;
  for (const auto& [key, bins] : lines) {
    const Bins filled = Filled(bins);
    left_out = left_out || filled.size() < bins.size();
    if (!filled.empty()) AddSeries(NameOf(key, agents), filled, &charts);
  }
  if (charts.front().series.empty()) return {};
  for (Chart& chart : charts) {
    if (left_out) chart.x_label += fmt::format(", where {} episodes or more", kLeastEpisodes);
  }
  return charts;
}

}  // namespace bulletnav::bench
