// SPDX-License-Identifier: MIT
#include "benchmark/runs/runner.h"

#include <map>
#include <mutex>
#include <vector>

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/base/gzip.h"
#include "benchmark/base/processor_kind.h"
#include "benchmark/base/program_version.h"
#include "benchmark/runs/agent_models.h"
#include "benchmark/runs/result_store.h"
#include "benchmark/runs/run_play.h"
#include "benchmark/runs/shard_record.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

std::vector<AgentRow> AgentRows(const std::vector<RunAgent>& agents) {
  std::vector<AgentRow> rows;
  rows.reserve(agents.size());
  for (const RunAgent& agent : agents) rows.push_back(agent.row());
  return rows;
}

StartProgress StartOf(const RunHooks& hooks) {
  if (hooks.prepare) return hooks.prepare;
  return [](const std::string& /*what*/, int /*total*/) {
    return [] {};
  };
}

/// Leaves the jobs that have no result yet; returns the results of the others.
std::vector<EpisodeResult> TakeDone(const ResultStore& store, const RunPlan& plan,
                                    std::vector<RunJob>* jobs) {
  std::map<ResultKey, EpisodeResult> stored;
  for (EpisodeResult& result : store.results()) stored.emplace(result.key, std::move(result));
  std::vector<EpisodeResult> done;
  std::erase_if(*jobs, [&](const RunJob& job) {
    const auto found = stored.find(plan.KeyOf(job));
    if (found == stored.end()) return false;
    done.push_back(found->second);
    return true;
  });
  return done;
}

/// Takes finished episodes to the disk and tells of them, from any thread.
class Recorder {
 public:
  Recorder(const RunPlan& plan, ResultStore* store, const RunHooks& hooks)
      : keeps_trajectories_(plan.config.trajectories), store_(*store), hooks_(hooks) {}

  void Record(const EpisodeTrajectory& trajectory, const BeliefLog& beliefs) {
    if (!beliefs.empty()) {
      sim::WriteFileAtomically(BeliefPath(store_.folder(), trajectory.result.key),
                               Compress(beliefs.ToJson()));
    }
    // The trajectory first: whoever finds the result finds it too.
    if (keeps_trajectories_) {
      sim::WriteFileAtomically(TrajectoryPath(store_.folder(), trajectory.result.key),
                               ToJson(trajectory));
    }
    store_.Append(trajectory.result);
    const std::lock_guard lock(telling_);
    if (hooks_.finish) hooks_.finish(trajectory.result);
  }

 private:
  bool keeps_trajectories_;
  ResultStore& store_;
  const RunHooks& hooks_;
  std::mutex telling_;
};

/// Plays what there is no result of yet.
void PlayRest(const RunPlan& plan, int workers, const RunHooks& hooks, SceneCache* scenes,
              ResultStore* store) {
  std::vector<RunJob> jobs = JobsOf(plan);
  const std::vector<EpisodeResult> done = TakeDone(*store, plan, &jobs);
  if (!jobs.empty()) NoteVersion(store->folder());
  if (hooks.missing) hooks.missing(MissingAgents(plan.agents));
  if (hooks.begin) hooks.begin(done.size() + jobs.size(), done);
  Recorder recorder(plan, store, hooks);
  PlayJobs(plan, jobs, workers, scenes,
           [&](const EpisodeTrajectory& trajectory, const BeliefLog& beliefs) {
             recorder.Record(trajectory, beliefs);
           });
}

std::vector<std::string> TellFailures(std::span<const EpisodeResult> results) {
  std::map<std::string, std::vector<const EpisodeResult*>> failed;
  for (const EpisodeResult& result : results) {
    if (!result.failure.empty()) failed[result.key.agent].push_back(&result);
  }
  std::vector<std::string> told;
  for (const auto& [agent, of_agent] : failed) {
    const EpisodeResult& first = *of_agent.front();
    told.push_back(fmt::format("{} of {} failed, as {}: {}", Counted(of_agent.size(), "episode"),
                               agent, first.key.episode, first.failure));
  }
  return told;
}

/// The fingerprints of a saved config; absent if another version of the program saved it.
std::optional<Fingerprints> SavedFingerprints(const std::string& config) {
  try {
    return ParseRunConfig(config, "config.yaml").fingerprints;
  } catch (const sim::Error&) {
    return std::nullopt;
  }
}

}  // namespace

bool LacksOnlyWeights(const std::string& saved, const RunConfig& config) {
  try {
    RunConfig old = ParseRunConfig(saved, "config.yaml");
    if (!old.fingerprints || !config.fingerprints) return false;
    auto& weights = old.fingerprints->weights;
    weights.insert(config.fingerprints->weights.begin(), config.fingerprints->weights.end());
    if (!old.fingerprints->sources) old.fingerprints->sources = config.fingerprints->sources;
    return sim::ToYaml(old) == sim::ToYaml(config);
  } catch (const sim::Error&) {
    return false;  // of another version of the program
  }
}

RunOutcome Summarise(const RunPlan& plan, fs::path folder, std::vector<EpisodeResult> results) {
  RunOutcome outcome;
  outcome.folder = std::move(folder);
  outcome.results = std::move(results);
  outcome.failures = TellFailures(outcome.results);
  outcome.agents = AgentRows(plan.agents);
  return outcome;
}

RunOutcome RunBenchmark(RunConfig config, const fs::path& folder, const RunOptions& options,
                        const RunHooks& hooks) {
  RequireSplit(folder, options.shard);
  const bool beliefs = options.beliefs || config.beliefs.value_or(false);
  config.beliefs.reset();  // results do not depend on it, nor do the bytes of what is saved
  ResolvedRun run = ResolveRun(std::move(config), options.require_all);
  RequireSameSources(run.config.fingerprints, run.agents);
  SceneCache scenes(run.config.world_options());
  scenes.WarnOfGrey(hooks.warn);
  RunEpisodes episodes =
      PrepareEpisodes(&run.config, {options.episodes, options.shard, options.only},
                      {scenes, options.workers, StartOf(hooks), hooks.warn});
  run.config.fingerprints->sources = SourceHashes(run.agents);
  RunPlan plan = PlanRun(std::move(run), std::move(episodes));
  plan.beliefs = beliefs;
  const fs::path place = options.shard ? ShardFolder(folder, *options.shard) : folder;
  ResultStore store(place, sim::ToYaml(plan.config), [&](const std::string& saved) {
    RequireSameSources(SavedFingerprints(saved), plan.agents);
    return LacksOnlyWeights(saved, plan.config);
  });
  if (options.shard) {
    BeginShard(place, MakeShardRecord(*options.shard, options.episodes, plan.config.backend,
                                      ActsInFloats(plan.config) ? ProcessorKind() : kAnyProcessor));
  }
  if (options.retry_failed) store.ForgetFailed();
  PlayRest(plan, options.workers, hooks, &scenes, &store);
  store.PutInOrder();
  return Summarise(plan, place, store.results());
}

std::vector<AgentRow> AgentRowsOf(const RunConfig& config) {
  return AgentRows(FindAgents(config));
}

}  // namespace bulletnav::bench
