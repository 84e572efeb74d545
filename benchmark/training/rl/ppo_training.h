// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "benchmark/training/core/train_plan.h"
#include "benchmark/training/core/training.h"
#include "benchmark/training/rl/ppo.h"

namespace bulletnav::bench {

/// What every training by PPO is told beside its task; `steps` are rollouts with their updates.
struct PpoPlan : TrainPlan {
  PpoSpec ppo;

  template <class V>
  void Visit(V& v) {
    TrainPlan::Visit(v);
    v("ppo", ppo);
  }
  /// Throws Error.
  void Validate() const { TrainPlan::Validate(); }
  /// By the schedule, whose warm-up begins again after ppo.value_first.
  double RateAt(int step) const;
  bool heeds_device() const { return false; }  // groups of lanes are on processors
};

/// Recurrent PPO on a task. The config, the number of the rollout and the checkpoint's state decide
/// all bits: killed and begun again, it ends as if it had not been, on any number of threads and of
/// processes.
class PpoTraining : public Training {
 public:
  /// `task` is made with the pool, for its own work; of the lanes that Share says. `make`: always
  /// the same net. `peers`: null if the task's lanes cannot be shared.
  PpoTraining(const PpoPlan& plan, const ActorCriticMaker& make,
              const std::function<std::unique_ptr<PolicyTask>(sim::WorkerPool*)>& task,
              std::shared_ptr<Peers> peers = nullptr);
  /// The lanes of a process. Throws Error if they cannot be shared.
  static LaneShare Share(const PpoSpec& spec, const Peers* peers);

  torch::nn::Module& net() override { return *net_; }
  std::optional<double> RateAt(int step) const override { return plan_.RateAt(step); }
  double Learn(const TrainStep& step) override;
  std::int64_t FramesAfter(int steps) const override;
  std::string frames_are() const override { return "steps of the task"; }
  bool shares_work() const override { return peers_ != nullptr; }
  /// The net's weights as floats, unless overridden.
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override;
  void AppendState(agent::TensorFile* content) const override;
  void SetState(const agent::TensorFile& content, const std::filesystem::path& file) override;

 protected:
  /// How the last update went, and the mean return, without discount, of the episodes that ended in
  /// training since the last call in which there were any, under their names. For all processes to
  /// call.
  void AppendReport(Measures* measures);
  /// Notes for weights, and how returns spread, by which the values in them are normalised; and
  /// back from weights that are gone on from, if they have it. Throws FileError if it is damaged.
  std::map<std::string, std::string> WithReturns(std::map<std::string, std::string> notes) const;
  void TakeReturns(const std::filesystem::path& weights);
  const ActorCritic& policy() const { return *net_; }
  ActorCritic& policy() { return *net_; }
  const RunningMoments& moments() const { return moments_; }
  sim::WorkerPool* pool() { return &pool_; }

 private:
  void TakeEpisodeReturn();

  PpoPlan plan_;
  std::shared_ptr<Peers> peers_;  // or null
  sim::WorkerPool pool_;
  std::unique_ptr<ActorCritic> net_;
  std::unique_ptr<PolicyTask> task_;
  LaneGroups groups_;
  std::unique_ptr<Actor> actor_;
  RunningMoments moments_;
  PpoReport report_;
  double episode_return_ = 0.0;  // see AppendReport
};

}  // namespace bulletnav::bench
