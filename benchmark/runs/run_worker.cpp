// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_worker.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include <fmt/core.h>
#include <sched.h>
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

}  // namespace

ResultKey RunPlan::KeyOf(const RunJob& job) const {
  const RunRow& row = rows[job.row];
  const Episode& episode = episodes.episodes[job.episode];
  return {agents[row.agent].entry.name,
          std::string(sim::NameOf(row.setting)),
          std::string(sim::NameOf(row.condition)),
          row.seed,
          episode.scene,
          episode.id};
}

void RunWorker::Work() {
  try {
    thread_ = ::gettid();
    std::size_t lanes = 1;
    for (const RunAgent& agent : plan_.agents) {
      lanes = std::max(lanes, static_cast<std::size_t>(agent.entry.lanes));
    }
    for (std::size_t i = 0; i < lanes; ++i) lanes_.push_back(std::make_unique<Lane>());
    while (const auto job = shared_->queue.Take()) {
      if (!PlayRow(*job)) return;
    }
  } catch (...) {
    shared_->queue.Abort(std::current_exception());
  }
}

agent::BatchAgent& RunWorker::AgentFor(std::size_t row) {
  const RunAgent& agent = plan_.agents[agent_of(row)];
  const Setting setting = plan_.rows[row].setting;
  std::unique_ptr<agent::BatchAgent>& built = agents_[{agent_of(row), setting}];
  if (!built) {
    std::vector<const GroundTruth*> truths;
    truths.reserve(lanes_.size());
    for (int i = 0; i < agent.entry.lanes; ++i) {
      truths.push_back(&lanes_[static_cast<std::size_t>(i)]->truth);
    }
    built = Build(agent, plan_.config, setting, truths);
  }
  return *built;
}

void RunWorker::StartLane(Lane* lane, const RunJob& job) {
  const Episode& episode = plan_.episodes.episodes[job.episode];
  EpisodeTask task{plan_.KeyOf(job), episode, plan_.episodes.scene_files.at(episode.scene)};
  const bool sees = !plan_.agents[agent_of(job.row)].is_privileged;
  const RunRow& row = plan_.rows[job.row];
  lane->job = job;
  lane->agent_s = 0.0;
  lane->run.emplace(std::move(task), RulesOf(plan_.config, row.setting, row.condition, sees),
                    shared_->worlds.Get(episode.scene), &lane->truth);
}

bool RunWorker::PlayRow(const RunJob& first) {
  row_ = first.row;
  const auto lanes = static_cast<std::size_t>(plan_.agents[agent_of(row_)].entry.lanes);
  StartLane(lanes_[0].get(), first);
  while (true) {
    for (std::size_t i = 0; i < lanes && !first.alone; ++i) {
      if (lanes_[i]->run) continue;
      const auto job = shared_->queue.TakeOfRow(row_);
      if (!job) break;
      StartLane(lanes_[i].get(), *job);
    }
    if (Going().empty()) return true;
    if (!PlayOn()) return false;
  }
}

std::vector<std::size_t> RunWorker::Going() const {
  std::vector<std::size_t> going;
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    if (lanes_[i]->run) going.push_back(i);
  }
  return going;
}

/// What the agent believes, for drawing. That is no part of the episode: if it fails, there is
/// none. Absent if the worker was given up.
std::optional<agent::Belief> RunWorker::AskBelief(std::size_t lane) {
  agent::Belief belief;
  if (!plan_.config.trajectories) return belief;
  if (!clock_.Begin()) return std::nullopt;
  try {
    belief = AgentFor(row_).belief(static_cast<int>(lane));
  } catch (const std::exception&) {
    belief = {};
  }
  if (!clock_.End()) return std::nullopt;
  if (!IsFinite(belief.pose) || !IsFinite(belief.target)) belief = {};
  return belief;
}

/// One step of all lanes.
bool RunWorker::PlayOn() {
  if (shared_->queue.aborted()) return false;
  for (const std::size_t lane : Going()) {
    if (lanes_[lane]->run->TakeNewGoal() && !TellGoal(lane)) return false;
  }
  std::vector<std::size_t> lanes;
  for (const std::size_t lane : Going()) {
    if (!lanes_[lane]->run->is_over()) lanes.push_back(lane);
  }
  if (!lanes.empty() && !Act(lanes)) return false;
  for (const std::size_t lane : Going()) {
    if (!lanes_[lane]->run->is_over()) continue;
    std::optional<agent::Belief> belief = AskBelief(lane);
    if (!belief) return false;
    Settle(lanes_[lane].get(), std::move(*belief));
  }
  return true;
}

bool RunWorker::TellGoal(std::size_t lane) {
  EpisodeRun& run = *lanes_[lane]->run;
  if (run.is_over()) return true;
  agent::BatchAgent& agent = AgentFor(row_);
  const Called called = Call({lane}, [&] {
    const auto number = static_cast<int>(lane);
    if (run.is_first_goal()) {
      agent.Reset(number, run.goal(), run.agent_seed());
    } else {
      agent.NextGoal(number, run.goal(), run.agent_seed());
    }
  });
  return called != Called::kGivenUp;
}

bool RunWorker::Act(const std::vector<std::size_t>& lanes) {
  std::vector<agent::LaneObservation> observations;
  observations.reserve(lanes.size());
  for (const std::size_t lane : lanes) {
    observations.push_back({static_cast<int>(lane), lanes_[lane]->run->Look()});
  }
  // What an agent does not answer is no action.
  std::vector<sim::Action> actions(lanes.size(), static_cast<sim::Action>(-1));
  agent::BatchAgent& agent = AgentFor(row_);
  const Called called = Call(lanes, [&] {
    agent.Act(observations, actions);
  });
  if (called != Called::kWell) return called == Called::kFailed;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    if (IsAction(actions[i])) {
      lanes_[lanes[i]]->run->Apply(actions[i]);
    } else {
      lanes_[lanes[i]]->run->Fail(
          fmt::format("answered {}, which is no action", static_cast<int>(actions[i])));
    }
  }
  return true;
}

RunWorker::Called RunWorker::Call(const std::vector<std::size_t>& lanes,
                                  const std::function<void()>& call) {
  if (!clock_.Begin()) return Called::kGivenUp;
  std::string why;
  try {
    call();
  } catch (const std::exception& e) {
    why = std::string("threw: ") + e.what();
  } catch (...) {
    why = "threw something that is no exception";
  }
  const std::optional<double> seconds = clock_.End();
  if (!seconds) return Called::kGivenUp;
  const TimeBudget& budget = plan_.config.time_budget;
  for (const std::size_t lane : lanes) {
    lanes_[lane]->agent_s += *seconds / static_cast<double>(lanes.size());
    if (why.empty() && lanes_[lane]->agent_s > budget.episode_s) {
      why = fmt::format("took longer than {:g} s for an episode", budget.episode_s);
    }
  }
  if (why.empty()) return Called::kWell;
  FailLanes(lanes, why);
  return Called::kFailed;
}

std::string RunWorker::TooSlow() const {
  return fmt::format("took longer than {:g} s for one answer", plan_.config.time_budget.call_s);
}

/// Of several lanes nobody knows which one was to blame: each is played again by itself.
void RunWorker::FailLanes(const std::vector<std::size_t>& lanes, const std::string& why) {
  for (const std::size_t lane : lanes) {
    if (lanes.size() == 1) {
      lanes_[lane]->run->Fail(why);
    } else {
      shared_->queue.PutBackAlone(lanes_[lane]->job);
      lanes_[lane]->run.reset();
    }
  }
}

void RunWorker::Settle(Lane* lane, agent::Belief belief) {
  const EpisodeTrajectory trajectory = lane->run->Finish(std::move(belief));
  lane->run.reset();
  shared_->finish(trajectory);
  shared_->worlds.Done(trajectory.result.key.scene);
}

bool RunWorker::GiveUpIfHung(double seconds) {
  if (!clock_.Tick(seconds, plan_.config.time_budget.call_s)) return false;
  // It may spin for ever; let it take only what nobody else wants.
  const sched_param idle{};
  ::sched_setscheduler(thread_, SCHED_IDLE, &idle);
  const std::vector<std::size_t> lanes = Going();
  for (const std::size_t lane : lanes) {
    EpisodeRun& run = *lanes_[lane]->run;
    if (lanes.size() > 1 && !run.is_over()) {
      shared_->queue.PutBackAlone(lanes_[lane]->job);
      continue;
    }
    if (!run.is_over()) run.Fail(TooSlow());
    const EpisodeTrajectory trajectory = run.Finish({});
    shared_->finish(trajectory);
    shared_->worlds.Done(trajectory.result.key.scene);
  }
  return true;
}

}  // namespace bulletnav::bench
