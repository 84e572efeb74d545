// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_plan.h"

#include <map>
#include <string>
#include <utility>

namespace bulletnav::bench {
namespace {

void AddRows(const RunConfig& config, std::size_t agent, const std::string& setting,
             std::vector<RunRow>* rows) {
  for (const Condition condition : config.conditions) {
    for (const std::uint64_t seed : config.seeds)
      rows->push_back({agent, setting, condition, seed});
  }
}

std::vector<RunRow> RowsOf(const RunConfig& config, const std::vector<RunAgent>& agents) {
  std::vector<RunRow> rows;
  for (std::size_t agent = 0; agent < agents.size(); ++agent) {
    for (const std::string& setting : agents[agent].settings)
      AddRows(config, agent, setting, &rows);
  }
  return rows;
}

}  // namespace

ResolvedRun ResolveRun(RunConfig config, bool require_all) {
  ResolvedRun run;
  run.agents = FindAgents(config);
  if (require_all) RequireAll(run.agents);
  RequireSome(run.agents);
  run.config = std::move(config);
  return run;
}

RunPlan PlanRun(ResolvedRun run, RunEpisodes episodes) {
  RunPlan plan;
  plan.rows = RowsOf(run.config, run.agents);
  plan.config = std::move(run.config);
  plan.agents = std::move(run.agents);
  plan.episodes = std::move(episodes);
  return plan;
}

std::vector<RunJob> JobsOf(const RunPlan& plan) {
  const std::vector<Episode>& episodes = plan.episodes.episodes;
  std::vector<std::string> scenes;
  std::map<std::string, std::vector<std::size_t>> by_scene;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    std::vector<std::size_t>& list = by_scene[episodes[i].scene];
    if (list.empty()) scenes.push_back(episodes[i].scene);
    list.push_back(i);
  }
  std::vector<RunJob> jobs;
  for (const std::string& scene : scenes) {
    for (std::size_t row = 0; row < plan.rows.size(); ++row) {
      for (const std::size_t episode : by_scene[scene]) jobs.push_back({row, episode, false});
    }
  }
  return jobs;
}

}  // namespace bulletnav::bench
