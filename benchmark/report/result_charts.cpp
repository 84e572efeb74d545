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

}  // namespace

std::vector<Chart> GoalCountCharts(std::span<const SummaryRow> rows,
                                   std::span<const AgentRow> agents) {
  std::map<LineKey, std::map<int, const SummaryRow*>> lines;
  for (const SummaryRow& row : rows) {
    int goals = 0;
    if (std::sscanf(row.difficulty.c_str(), "goals_%9d", &goals) != 1) continue;
    lines[KeyOf(row, agents)][goals] = &row;
  }
  if (lines.empty()) return {};
  const std::vector<Measure> measures = MainMeasures();
  std::vector<Chart> charts = EmptyCharts("number of goals");
  for (const auto& [key, line] : lines) {
    for (std::size_t i = 0; i < charts.size(); ++i) {
      auto& values = charts[i].series.emplace_back(NameOf(key, agents)).values;
      for (const auto& [goals, row] : line) {
        const Average average = row->Of(measures[i].name);
        if (!average.mean || !average.interval) continue;
        values.push_back({static_cast<double>(goals), *average.mean, *average.interval});
      }
    }
  }
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
  const std::vector<Measure> measures = MainMeasures();
  std::vector<Chart> charts = EmptyCharts("geodesic distance to the goal (m)");
  bool left_out = false;
  for (const auto& [key, bins] : lines) {
    const Bins filled = Filled(bins);
    left_out = left_out || filled.size() < bins.size();
    if (filled.empty()) continue;
    for (std::size_t i = 0; i < charts.size(); ++i) {
      auto& values = charts[i].series.emplace_back(NameOf(key, agents)).values;
      for (const auto& [metre, bin] : filled) {
        if (const auto value = ValueAt(metre + 0.5, bin, measures[i])) values.push_back(*value);
      }
    }
  }
  if (charts.front().series.empty()) return {};
  for (Chart& chart : charts) {
    if (left_out) chart.x_label += fmt::format(", where {} episodes or more", kLeastEpisodes);
  }
  return charts;
}

}  // namespace bulletnav::bench
