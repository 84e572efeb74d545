// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>

#include "benchmark/play/episode_result.h"
#include "benchmark/report/results_table.h"
#include "benchmark/runs/summary.h"

namespace bulletnav::bench {

/// Success and SPL of each agent in each scene, a row a scene and setting, under the first
/// condition that there are results of; means over scenes say little where scenes differ much.
/// Scenes are called as SceneNames has it. Absent for fewer than two scenes, or more than 40.
std::optional<ResultsTable> SceneTable(std::span<const EpisodeResult> results,
                                       std::span<const AgentRow> agents);

}  // namespace bulletnav::bench
