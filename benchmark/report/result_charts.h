// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "benchmark/report/chart.h"
#include "benchmark/runs/summary.h"

namespace bulletnav::bench {

/// A chart of each main measure of sequences by number of goals, from the rows "goals_1",
/// "goals_2", ...: one series an agent, setting and condition. Empty if there are no such rows.
std::vector<Chart> GoalCountCharts(std::span<const SummaryRow> rows,
                                   std::span<const AgentRow> agents);

/// A chart of each main measure of single goals, with its interval, by geodesic distance from start
/// to goal, in bins of a metre, at their middles. Bins of under five episodes are left out.
std::vector<Chart> DistanceCharts(std::span<const EpisodeResult> results,
                                  std::span<const AgentRow> agents);

}  // namespace bulletnav::bench
