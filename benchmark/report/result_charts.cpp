// SPDX-License-Identifier: MIT
#include "benchmark/report/result_charts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
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

/// Success and SPL with nothing in them yet.
std::vector<Chart> EmptyCharts(const std::string& x_label) {
  return {{x_label, "success", {}}, {x_label, "SPL", {}}};
}

struct Bin {
  std::vector<double> spl;
  int successes = 0;
};

/// The same for the same values in any order.
Interval SplInterval(std::vector<double> spl) {
  std::sort(spl.begin(), spl.end());
  return BootstrapInterval(spl, kBootstrapSeed);
}

using Bins = std::map<int, Bin>;  // by the metre they begin at

Bins Filled(const Bins& bins) {
  Bins filled;
  for (const auto& [metre, bin] : bins) {
    if (bin.spl.size() >= kLeastEpisodes) filled[metre] = bin;
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
  std::vector<Chart> charts = EmptyCharts("number of goals");
  for (const auto& [key, line] : lines) {
    for (Chart& chart : charts) chart.series.push_back({NameOf(key, agents), {}});
    for (const auto& [goals, row] : line) {
      const auto x = static_cast<double>(goals);
      charts[0].series.back().values.push_back({x, row->success, row->success_ci});
      charts[1].series.back().values.push_back({x, row->spl, row->spl_ci});
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
    Bin& bin = lines[KeyOf(result.key, agents)][static_cast<int>(std::floor(goal.start_distance))];
    bin.spl.push_back(goal.spl);
    bin.successes += goal.success ? 1 : 0;
  }
  std::vector<Chart> charts = EmptyCharts("geodesic distance to the goal (m)");
  bool left_out = false;
  for (const auto& [key, bins] : lines) {
    const Bins filled = Filled(bins);
    left_out = left_out || filled.size() < bins.size();
    if (filled.empty()) continue;
    for (Chart& chart : charts) chart.series.push_back({NameOf(key, agents), {}});
    for (const auto& [metre, bin] : filled) {
      const double x = metre + 0.5;
      const auto count = static_cast<int>(bin.spl.size());
      const double share = static_cast<double>(bin.successes) / count;
      charts[0].series.back().values.push_back({x, share, WilsonInterval(bin.successes, count)});
      charts[1].series.back().values.push_back({x, Mean(bin.spl), SplInterval(bin.spl)});
    }
  }
  if (charts.front().series.empty()) return {};
  for (Chart& chart : charts) {
    if (left_out) chart.x_label += fmt::format(", where {} episodes or more", kLeastEpisodes);
  }
  return charts;
}

}  // namespace bulletnav::bench
