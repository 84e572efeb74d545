// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "benchmark/runs/run_agents.h"
#include "benchmark/runs/run_config.h"
#include "benchmark/runs/run_episodes.h"
#include "benchmark/runs/run_worker.h"

namespace bulletnav::bench {

/// Stage "resolve": a config, and what can be run of its agents.
struct ResolvedRun {
  RunConfig config;
  std::vector<RunAgent> agents;
};

/// Throws as RequireSome and, with `require_all`, RequireAll.
ResolvedRun ResolveRun(RunConfig config, bool require_all);

/// Stage "plan": each agent, in its settings, under every condition and seed.
RunPlan PlanRun(ResolvedRun run, RunEpisodes episodes);
/// Every episode of every row, scene by scene, so that each is loaded once; in a scene row by row.
std::vector<RunJob> JobsOf(const RunPlan& plan);

}  // namespace bulletnav::bench
