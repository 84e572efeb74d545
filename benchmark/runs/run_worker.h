// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/episodes/scene_cache.h"
#include "benchmark/play/belief_log.h"
#include "benchmark/play/environment.h"
#include "benchmark/runs/call_watch.h"
#include "benchmark/runs/run_agents.h"
#include "benchmark/runs/run_episodes.h"
#include "benchmark/runs/run_queue.h"

namespace bulletnav::bench {

/// What is to be played.
struct RunPlan {
  RunConfig config;
  std::vector<RunAgent> agents;
  RunEpisodes episodes;
  std::vector<RunRow> rows;
  bool beliefs = false;  // whether they are logged

  ResultKey KeyOf(const RunJob& job) const;
};

/// Takes a finished episode, and what its agent believed: empty unless that is logged.
using TakeEpisode = std::function<void(const EpisodeTrajectory&, const BeliefLog&)>;

/// What all workers of a run share.
struct RunShared {
  const RunPlan& plan;
  RunQueue queue;
  SceneCache& scenes;
  TakeEpisode finish;  // called from any thread
  CallWatch watch = {};
};

/// One thread of a run: takes jobs and plays them, several at once where the agent asks for it. A
/// foreign agent that neither answers nor can be interrupted fails its episode; the process, which
/// cannot go on beside it, then ends with a line that says so, all results being on the disk.
class RunWorker {
 public:
  explicit RunWorker(RunShared* shared);
  ~RunWorker();
  RunWorker(const RunWorker&) = delete;
  RunWorker& operator=(const RunWorker&) = delete;
  RunWorker(RunWorker&&) = delete;
  RunWorker& operator=(RunWorker&&) = delete;

  /// Plays until no job is left; hands what goes wrong to the queue.
  void Work();

 private:
  enum class CallState { kNone, kAtWork, kGivenUp };
  void PlayRow(const RunJob& first);
  void Enter(std::size_t row);
  void Start(int lane, const RunJob& job);
  void PlayOn();
  void TellGoal(int lane);
  void Act(const std::vector<int>& lanes);
  /// Calls the agent on behalf of some lanes; false if it failed them.
  bool Call(const std::vector<int>& lanes, const std::function<void()>& call);
  void Guarded(const std::function<void()>& call);
  void Watch(agent::BatchAgent* agent);
  void GiveUp(const agent::ForeignAgent& agent, const agent::ForeignCall& call);
  void FailLanes(const std::vector<int>& lanes, const std::string& why);
  agent::Belief AskBelief(int lane);
  void Settle(int lane);
  std::vector<int> Playing() const;
  agent::BatchAgent& AgentFor(std::size_t row);
  const RunAgent& agent_of(std::size_t row) const { return plan_.agents[plan_.rows[row].agent]; }

  RunShared& shared_;
  const RunPlan& plan_;
  std::vector<GroundTruth> truths_;  // of the lanes
  std::vector<RunJob> jobs_;
  std::vector<BeliefLog> logs_;
  std::size_t row_ = 0;
  std::unique_ptr<Environment> environment_;  // of the row
  std::map<std::pair<std::size_t, std::string>, std::unique_ptr<agent::BatchAgent>> agents_;
  std::atomic<CallState> call_ = CallState::kNone;
};

}  // namespace bulletnav::bench
