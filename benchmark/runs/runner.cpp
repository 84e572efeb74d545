// SPDX-License-Identifier: MIT
#include "benchmark/runs/runner.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/base/program_version.h"
#include "benchmark/runs/result_store.h"
#include "benchmark/runs/run_worker.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

void AddRows(const RunConfig& config, std::size_t agent, Setting setting,
             std::vector<RunRow>* rows) {
  for (const Condition condition : config.conditions) {
    for (const std::uint64_t seed : config.seeds)
      rows->push_back({agent, setting, condition, seed});
  }
}

std::vector<RunRow> RowsOf(const RunConfig& config, const std::vector<RunAgent>& agents) {
  std::vector<RunRow> rows;
  for (std::size_t agent = 0; agent < agents.size(); ++agent) {
    for (const Setting setting : agents[agent].settings) AddRows(config, agent, setting, &rows);
  }
  return rows;
}

/// Scene by scene, so that each is loaded once; in a scene row by row.
std::vector<RunJob> JobsOf(const std::vector<Episode>& episodes, std::size_t rows) {
  std::vector<std::string> scenes;
  std::map<std::string, std::vector<std::size_t>> by_scene;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    std::vector<std::size_t>& list = by_scene[episodes[i].scene];
    if (list.empty()) scenes.push_back(episodes[i].scene);
    list.push_back(i);
  }
  std::vector<RunJob> jobs;
  for (const std::string& scene : scenes) {
    for (std::size_t row = 0; row < rows; ++row) {
      for (const std::size_t episode : by_scene[scene]) jobs.push_back({row, episode, false});
    }
  }
  return jobs;
}

int WorkerCount(int workers) {
  return workers > 0 ? workers : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Plays all jobs in threads of their own.
void PlayAll(RunShared* shared, std::size_t workers) {
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < workers; ++i) {
    threads.emplace_back([shared] {
      RunWorker(shared).Work();
    });
  }
  for (std::thread& thread : threads) thread.join();
  shared->queue.Rethrow();
}

std::vector<AgentRow> AgentRows(const std::vector<RunAgent>& agents) {
  std::vector<AgentRow> rows;
  rows.reserve(agents.size());
  for (const RunAgent& agent : agents) rows.push_back(agent.row());
  return rows;
}

/// Everything that is to be played, whether it has been or not.
struct Work {
  std::shared_ptr<RunPlan> plan;
  std::vector<RunJob> jobs;
};

Work PlanWork(RunConfig config, const RunOptions& options, int workers, const RunHooks& hooks) {
  Work work;
  work.plan = std::make_shared<RunPlan>();
  RunPlan& plan = *work.plan;
  plan.agents = FindAgents(config);
  if (options.require_all) RequireAll(plan.agents);
  RequireSome(plan.agents);
  const StartProgress quiet = [](const std::string& /*what*/, int /*total*/) {
    return [] {};
  };
  plan.episodes =
      PrepareEpisodes(&config, options.episodes, workers, hooks.prepare ? hooks.prepare : quiet);
  plan.config = std::move(config);
  plan.rows = RowsOf(plan.config, plan.agents);
  work.jobs = JobsOf(plan.episodes.episodes, plan.rows.size());
  return work;
}

/// Leaves the jobs that have no result yet; returns the results of the others.
std::vector<EpisodeResult> TakeDone(const ResultStore& store, Work* work) {
  std::map<ResultKey, EpisodeResult> stored;
  for (EpisodeResult& result : store.results()) stored.emplace(result.key, std::move(result));
  std::vector<EpisodeResult> done;
  std::erase_if(work->jobs, [&](const RunJob& job) {
    const auto found = stored.find(work->plan->KeyOf(job));
    if (found == stored.end()) return false;
    done.push_back(found->second);
    return true;
  });
  return done;
}

void Play(const Work& work, const fs::path& folder, int workers, const RunHooks& hooks,
          ResultStore* store) {
  const RunConfig& config = work.plan->config;
  std::mutex telling;
  const auto finish = [&](const EpisodeTrajectory& trajectory) {
    // The trajectory first: whoever finds the result finds it too.
    if (config.trajectories) {
      sim::WriteFileAtomically(TrajectoryPath(folder, trajectory.result.key), ToJson(trajectory));
    }
    store->Append(trajectory.result);
    const std::lock_guard lock(telling);
    if (hooks.finish) hooks.finish(trajectory.result);
  };
  RunShared shared{*work.plan, RunQueue(work.jobs),
                   WorldCache(config.world_options(), work.plan->episodes.scene_files), finish};
  for (const RunJob& job : work.jobs) shared.worlds.Expect(work.plan->KeyOf(job).scene);
  PlayAll(&shared, std::min(static_cast<std::size_t>(workers), work.jobs.size()));
}

/// Whether a saved config is this one but for weights that were not there yet: no agent that needs
/// them has run.
bool LacksOnlyWeights(const std::string& saved, const RunConfig& config) {
  try {
    RunConfig old = ParseRunConfig(saved, "config.yaml");
    if (!old.fingerprints || !config.fingerprints) return false;
    auto& weights = old.fingerprints->weights;
    weights.insert(config.fingerprints->weights.begin(), config.fingerprints->weights.end());
    return sim::ToYaml(old) == sim::ToYaml(config);
  } catch (const sim::Error&) {
    return false;  // of another version of the program
  }
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

}  // namespace

RunOutcome RunBenchmark(RunConfig config, const fs::path& folder, const RunOptions& options,
                        const RunHooks& hooks) {
  const int workers = WorkerCount(options.workers);
  Work work = PlanWork(std::move(config), options, workers, hooks);
  const RunConfig& planned = work.plan->config;
  ResultStore store(folder, sim::ToYaml(planned), [&](const std::string& saved) {
    return LacksOnlyWeights(saved, planned);
  });
  if (options.retry_failed) store.ForgetFailed();
  const std::vector<EpisodeResult> done = TakeDone(store, &work);
  if (!work.jobs.empty()) NoteVersion(folder);
  if (hooks.missing) hooks.missing(MissingAgents(work.plan->agents));
  if (hooks.begin) hooks.begin(done.size() + work.jobs.size(), done);
  RunOutcome outcome;
  Play(work, folder, workers, hooks, &store);
  outcome.results = store.results();
  outcome.failures = TellFailures(outcome.results);
  outcome.agents = AgentRows(work.plan->agents);
  return outcome;
}

std::vector<AgentRow> AgentRowsOf(const RunConfig& config) {
  return AgentRows(FindAgents(config));
}

}  // namespace bulletnav::bench
