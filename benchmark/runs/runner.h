// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/episodes/drawn_grey.h"
#include "benchmark/runs/run_agents.h"
#include "benchmark/runs/run_config.h"
#include "benchmark/runs/run_episodes.h"
#include "benchmark/runs/run_plan.h"

namespace bulletnav::bench {

struct RunOptions {
  std::optional<int> episodes;      // only so many, evenly over scenes and difficulties
  int workers = 0;                  // < 1: one per processor
  bool require_all = false;         // agents that cannot run are errors, not remarks in the table
  bool retry_failed = false;        // play episodes that failed again
  std::optional<Shard> shard = {};  // only this share, into a folder of its own below the run's
  bool beliefs = false;             // log them, also where the config does not say so
  std::vector<std::string> only = {};  // only episodes of these names; empty: all
};

/// What a run tells while it goes on; all may be empty.
struct RunHooks {
  StartProgress prepare;
  /// Once for each scene of which something is drawn grey, from any thread, one call at a time; and
  /// of episodes that are left out.
  Warn warn;
  /// Once, before `begin`: agents that are not played, and why; see MissingAgents.
  std::function<void(std::span<const std::string>)> missing;
  /// Once, before the first episode: how many results there will be, and those there already are.
  std::function<void(std::size_t total, std::span<const EpisodeResult> before)> begin;
  /// Each finished episode, one at a time.
  std::function<void(const EpisodeResult&)> finish;
};

struct RunOutcome {
  std::filesystem::path folder;        // where the results are
  std::vector<EpisodeResult> results;  // all of the folder's, those of earlier calls too
  std::vector<AgentRow> agents;        // how tables speak of the run's agents
  /// "3 episodes of NAME failed, as EPISODE: threw: ...", one an agent that failed any.
  std::vector<std::string> failures;
};

/// Stage "summarise", of the results that are in a folder.
RunOutcome Summarise(const RunPlan& plan, std::filesystem::path folder,
                     std::vector<EpisodeResult> results);

/// All stages of a run: resolve, houses, episodes, verify (run_episodes.h), plan (run_plan.h), play
/// (run_play.h), summarise. Plays every episode of a config that `folder` has no result of yet, and
/// writes there config.yaml (everything that results depend on), episodes.jsonl and trajectories;
/// of a shard, those of its share into ShardFolder, to be joined by MergeShards. What agents
/// believe goes into files beside (BeliefPath) where that is asked for; results do not tell whether
/// it was. Results depend on the config alone: not on workers, on other episodes, or on how often
/// the run was killed and started again; at the end of a run, episodes.jsonl has the same bytes
/// too. An agent that throws or answers with no action fails that episode, with the reason in its
/// result; what becomes of one that never answers is told at RunWorker. Throws sim::Error: see
/// PrepareEpisodes, RequireSome, RequireAll, ResultStore and BeginShard.
RunOutcome RunBenchmark(RunConfig config, const std::filesystem::path& folder,
                        const RunOptions& options, const RunHooks& hooks = {});

/// Whether results of a saved config, its YAML text, hold for this one: all but weights that were
/// not there yet is the same, so that no agent that needs them has run. Hashes of code that were
/// not kept yet pass too.
bool LacksOnlyWeights(const std::string& saved, const RunConfig& config);

/// How tables and charts speak of a run's agents.
std::vector<AgentRow> AgentRowsOf(const RunConfig& config);

}  // namespace bulletnav::bench
