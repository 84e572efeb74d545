// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "benchmark/play/episode_run.h"
#include "benchmark/runs/call_clock.h"
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

  ResultKey KeyOf(const RunJob& job) const;
};

/// What all workers of a run share. Outlives those of them that are given up.
struct RunShared {
  std::shared_ptr<const RunPlan> plan;
  RunQueue queue;
  WorldCache worlds;
  /// Takes a finished episode, from any thread.
  std::function<void(const EpisodeTrajectory&)> finish;
};

/// One thread of a run: takes jobs and plays them, several at once where the agent asks for it. A
/// worker whose agent hangs is given up: its thread never does anything again that others see.
class RunWorker {
 public:
  explicit RunWorker(std::shared_ptr<RunShared> shared)
      : shared_(std::move(shared)), plan_(*shared_->plan) {}

  /// Plays until no job is left or the worker was given up; hands what goes wrong to the queue.
  void Work();

  /// To be called by another thread whenever `seconds` have passed: if the agent has kept the
  /// worker waiting for too long, settles its episodes, gives the worker up and returns true.
  /// Throws what `finish` throws.
  bool GiveUpIfHung(double seconds);

 private:
  struct Lane {
    RunJob job;
    GroundTruth truth;
    std::optional<EpisodeRun> run;
    double agent_s = 0.0;  // that the agent has taken for this episode
  };
  enum class Called { kWell, kFailed, kGivenUp };

  /// False if the worker was given up.
  bool PlayRow(const RunJob& first);
  void StartLane(Lane* lane, const RunJob& job);
  bool PlayOn();
  std::optional<agent::Belief> AskBelief(std::size_t lane);
  bool TellGoal(std::size_t lane);
  bool Act(const std::vector<std::size_t>& lanes);
  /// Calls the agent on behalf of some lanes, with an eye on the clock.
  Called Call(const std::vector<std::size_t>& lanes, const std::function<void()>& call);
  void FailLanes(const std::vector<std::size_t>& lanes, const std::string& why);
  void Settle(Lane* lane, agent::Belief belief);
  std::string TooSlow() const;
  std::vector<std::size_t> Going() const;
  agent::BatchAgent& AgentFor(std::size_t row);
  std::size_t agent_of(std::size_t row) const { return plan_.rows[row].agent; }

  std::shared_ptr<RunShared> shared_;
  const RunPlan& plan_;
  CallClock clock_;
  pid_t thread_ = 0;
  std::vector<std::unique_ptr<Lane>> lanes_;
  std::size_t row_ = 0;
  std::map<std::pair<std::size_t, Setting>, std::unique_ptr<agent::BatchAgent>> agents_;
};

}  // namespace bulletnav::bench
