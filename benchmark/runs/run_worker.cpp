// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_worker.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>

#include <fmt/core.h>
#include <unistd.h>

namespace bulletnav::bench {
namespace {

bool IsAction(sim::Action action) {
  return std::find(sim::kAllActions.begin(), sim::kAllActions.end(), action) !=
         sim::kAllActions.end();
}

bool IsFinite(const std::optional<sim::PlanarPose>& pose) {
  return !pose || (std::isfinite(pose->x) && std::isfinite(pose->y) && std::isfinite(pose->yaw));
}

std::size_t MostLanes(const RunPlan& plan) {
  int lanes = 1;
  for (const RunAgent& agent : plan.agents) lanes = std::max(lanes, agent.entry.lanes);
  return static_cast<std::size_t>(lanes);
}

/// Without destructors: some thread is in code that does not come back.
[[noreturn]] void EndProcess(const std::string& why) {
  std::fflush(stdout);
  fmt::print(stderr, "bulletnav: error: {}\n", why);
  std::fflush(stderr);
  ::_exit(1);
}

}  // namespace

ResultKey RunPlan::KeyOf(const RunJob& job) const {
  const RunRow& row = rows[job.row];
  const Episode& episode = episodes.episodes[job.episode];
  return {agents[row.agent].entry.name,
          row.setting,
          std::string(sim::NameOf(row.condition)),
          row.seed,
          episode.scene,
          episode.id};
}

RunWorker::RunWorker(RunShared* shared)
    : shared_(*shared),
      plan_(shared->plan),
      truths_(MostLanes(plan_)),
      jobs_(truths_.size()),
      logs_(truths_.size()) {}

RunWorker::~RunWorker() {
  for (const auto& [row, built] : agents_) {
    shared_.watch.Remove(dynamic_cast<agent::ForeignAgent*>(built.get()));
  }
}

void RunWorker::Work() {
  try {
    while (const auto job = shared_.queue.Take()) PlayRow(*job);
  } catch (...) {
    shared_.queue.Abort(std::current_exception());
  }
}

agent::BatchAgent& RunWorker::AgentFor(std::size_t row) {
  const RunRow& of = plan_.rows[row];
  std::unique_ptr<agent::BatchAgent>& built = agents_[{of.agent, of.setting}];
  if (!built) {
    std::vector<const GroundTruth*> truths;
    truths.reserve(truths_.size());
    for (int i = 0; i < agent_of(row).entry.lanes; ++i) {
      truths.push_back(&truths_[static_cast<std::size_t>(i)]);
    }
    built = Build(agent_of(row), plan_.config, of.setting, truths);
    Watch(built.get());
  }
  return *built;
}

/// Makes ready to play a row, if that is not what was played last.
void RunWorker::Enter(std::size_t row) {
  if (environment_ && row_ == row) return;
  row_ = row;
  const RunRow& of = plan_.rows[row];
  std::vector<GroundTruth*> truths;
  truths.reserve(truths_.size());
  for (int i = 0; i < agent_of(row).entry.lanes; ++i) {
    truths.push_back(&truths_[static_cast<std::size_t>(i)]);
  }
  const bool sees = !agent_of(row).is_privileged;
  environment_ = std::make_unique<Environment>(TaskOf(plan_.config, of.setting, of.condition, sees),
                                               std::move(truths), /*threads=*/1);
}

void RunWorker::Start(int lane, const RunJob& job) {
  const Episode& episode = plan_.episodes.episodes[job.episode];
  jobs_[static_cast<std::size_t>(lane)] = job;
  logs_[static_cast<std::size_t>(lane)] = {};
  const std::filesystem::path& scene = plan_.episodes.scene_files.at(episode.scene);
  environment_->Reset(lane, {plan_.KeyOf(job), episode, scene}, shared_.scenes.Get(scene));
}

void RunWorker::PlayRow(const RunJob& first) {
  Enter(first.row);
  Start(0, first);
  while (true) {
    for (int lane = 0; lane < environment_->lanes() && !first.alone; ++lane) {
      if (environment_->has_episode(lane)) continue;
      const auto job = shared_.queue.TakeOfRow(row_);
      if (!job) break;
      Start(lane, *job);
    }
    if (Playing().empty() || shared_.queue.aborted()) return;
    PlayOn();
  }
}

/// Lanes that have an episode.
std::vector<int> RunWorker::Playing() const {
  std::vector<int> playing;
  for (int lane = 0; lane < environment_->lanes(); ++lane) {
    if (environment_->has_episode(lane)) playing.push_back(lane);
  }
  return playing;
}

/// One step of all lanes.
void RunWorker::PlayOn() {
  for (const int lane : Playing()) {
    if (environment_->TakeNewGoal(lane) && !environment_->is_over(lane)) TellGoal(lane);
  }
  std::vector<int> lanes;
  for (const int lane : Playing()) {
    if (!environment_->is_over(lane)) lanes.push_back(lane);
  }
  if (!lanes.empty()) Act(lanes);
  for (const int lane : Playing()) {
    if (environment_->is_over(lane)) Settle(lane);
  }
}

void RunWorker::TellGoal(int lane) {
  agent::BatchAgent& agent = AgentFor(row_);
  Call({lane}, [&] {
    if (environment_->is_first_goal(lane)) {
      agent.Reset(lane, environment_->goal(lane), environment_->agent_seed(lane));
    } else {
      agent.NextGoal(lane, environment_->goal(lane), environment_->agent_seed(lane));
    }
  });
}

void RunWorker::Act(const std::vector<int>& lanes) {
  environment_->Observe(lanes);
  std::vector<agent::LaneObservation> observations;
  observations.reserve(lanes.size());
  for (const int lane : lanes) observations.push_back({lane, environment_->observation(lane)});
  // What an agent does not answer is no action.
  std::vector<sim::Action> actions(lanes.size(), static_cast<sim::Action>(-1));
  agent::BatchAgent& agent = AgentFor(row_);
  const bool acted = Call(lanes, [&] {
    agent.Act(observations, actions);
  });
  if (!acted) return;
  std::vector<int> moving;
  std::vector<sim::Action> taken;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    if (IsAction(actions[i])) {
      moving.push_back(lanes[i]);
      taken.push_back(actions[i]);
    } else {
      environment_->Fail(
          lanes[i], fmt::format("answered {}, which is no action", static_cast<int>(actions[i])));
    }
  }
  for (const int lane : moving) {
    if (plan_.beliefs) logs_[static_cast<std::size_t>(lane)].Add(AskBelief(lane));
  }
  environment_->Step(moving, taken);
}

void RunWorker::Watch(agent::BatchAgent* agent) {
  auto* const foreign = dynamic_cast<agent::ForeignAgent*>(agent);
  if (foreign == nullptr) return;
  shared_.watch.Add(foreign, [this, foreign](const agent::ForeignCall& call) {
    GiveUp(*foreign, call);
  });
}

/// In the watch's thread, while this worker's own is in the call: what it plays is not touched.
void RunWorker::GiveUp(const agent::ForeignAgent& agent, const agent::ForeignCall& call) {
  auto at_work = CallState::kAtWork;
  if (!call_.compare_exchange_strong(at_work, CallState::kGivenUp)) return;  // it has come back
  const auto lane = static_cast<std::size_t>(call.lane);
  const ResultKey key = plan_.KeyOf(jobs_[lane]);
  environment_->Fail(call.lane, fmt::format("gave no answer within {:g} s, and could not be "
                                            "interrupted",
                                            agent.time_limit_s()));
  shared_.finish(environment_->Finish(call.lane, {}), logs_[lane]);
  const auto sources = agent.sources();
  EndProcess(fmt::format(
      "agent '{}'{} gave no answer in episode '{}' of {} within {:g} s and could not be "
      "interrupted: the episode has failed, all results are kept, and the same command plays the "
      "others",
      key.agent, sources.empty() ? "" : " (" + sources.front().string() + ")", key.episode,
      key.scene, agent.time_limit_s()));
}

/// A call that the watch may give up.
void RunWorker::Guarded(const std::function<void()>& call) {
  const auto leave = [this] {
    auto at_work = CallState::kAtWork;
    if (call_.compare_exchange_strong(at_work, CallState::kNone)) return;
    while (true) ::pause();  // the watch has this worker's episodes, and ends the process
  };
  call_ = CallState::kAtWork;
  try {
    call();
  } catch (...) {
    leave();
    throw;
  }
  leave();
}

bool RunWorker::Call(const std::vector<int>& lanes, const std::function<void()>& call) {
  try {
    Guarded(call);
    return true;
  } catch (const std::exception& e) {
    FailLanes(lanes, std::string("threw: ") + e.what());
  } catch (...) {
    FailLanes(lanes, "threw something that is no exception");
  }
  return false;
}

/// Of several lanes nobody knows which one was to blame: each is played again by itself.
void RunWorker::FailLanes(const std::vector<int>& lanes, const std::string& why) {
  for (const int lane : lanes) {
    if (lanes.size() == 1) {
      environment_->Fail(lane, why);
    } else {
      shared_.queue.PutBackAlone(jobs_[static_cast<std::size_t>(lane)]);
      environment_->Clear(lane);
    }
  }
}

/// What the agent believes, for drawing. That is no part of the episode: if it fails, there is
/// none.
agent::Belief RunWorker::AskBelief(int lane) {
  try {
    agent::Belief belief = AgentFor(row_).belief(lane);
    if (IsFinite(belief.pose) && IsFinite(belief.target)) return belief;
  } catch (const std::exception&) {
    // Nothing is drawn then.
  }
  return {};
}

void RunWorker::Settle(int lane) {
  const bool is_kept = plan_.config.trajectories;
  const EpisodeTrajectory trajectory =
      environment_->Finish(lane, is_kept ? AskBelief(lane) : agent::Belief());
  environment_->Clear(lane);
  shared_.finish(trajectory, logs_[static_cast<std::size_t>(lane)]);
  shared_.scenes.Done(plan_.episodes.scene_files.at(trajectory.result.key.scene));
}

}  // namespace bulletnav::bench
