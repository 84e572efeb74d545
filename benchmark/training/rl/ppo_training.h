// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/training/core/train_plan.h"
#include "benchmark/training/core/training.h"
#include "benchmark/training/rl/ppo.h"

namespace bulletnav::bench {

/// What every training by PPO is told beside its task; `steps` are rollouts with their updates.
struct PpoPlan : TrainPlan {
  PpoSpec ppo;
  PolicyNetSpec model;
  int validation_steps = 200;  // that an episode of a validation may take

  template <class V>
  void Visit(V& v) {
    TrainPlan::Visit(v);
    v("ppo", ppo);
    v("model", model);
    v("validation_steps", validation_steps);
  }
  /// Throws Error.
  void Validate() const {
    TrainPlan::Validate();
    internal::RequireAtLeast(1, validation_steps, "validation_steps");
  }
};

/// Recurrent PPO on a task. The config, the number of the rollout and the checkpoint's state decide
/// all bits: killed and begun again, it ends as if it had not been.
class PpoTraining : public Training {
 public:
  /// `validation`: the same task with other episodes.
  PpoTraining(const PpoPlan& plan, std::unique_ptr<PolicyTask> task,
              std::unique_ptr<PolicyTask> validation);

  torch::nn::Module& net() override { return net_; }
  double Learn(const TrainStep& step) override;
  /// "score" is the mean of the lanes' first episodes, acted as in training; one that does not end
  /// in time scores nothing. "loss" is what the score lacks of 1.
  Measures Validate() override;
  std::int64_t FramesAfter(int steps) const override;
  std::string frames_are() const override { return "steps of the task"; }
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override;
  void AppendState(agent::TensorFile* content) const override;
  void SetState(const agent::TensorFile& content, const std::filesystem::path& file) override;
  std::string Describe(const Measures& measures) const override;
  std::vector<CurveLine> curves() const override { return {{"score", "score"}}; }
  std::string validated_on() const override { return "episodes that no training has played"; }

 private:
  PpoPlan plan_;
  std::unique_ptr<PolicyTask> task_;
  std::unique_ptr<PolicyTask> validation_;
  PolicyNet net_;
  Actor actor_;
  RunningMoments moments_;
  PpoReport report_;
};

}  // namespace bulletnav::bench
