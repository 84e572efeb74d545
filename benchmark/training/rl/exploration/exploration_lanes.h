// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "benchmark/training/rl/exploration/exploration_scenes.h"
#include "benchmark/training/rl/exploration/map_simulator.h"
#include "benchmark/training/rl/policy_task.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

inline constexpr double kRewardPerArea = 0.02;  // for a m2 seen for the first time, or its worth

/// Goals as actions of a PolicyTask, and back.
int ActionOf(const agent::GoalSteps& goal);
agent::GoalSteps GoalOf(int action);

/// Exploring scenes by long-term goals: an action is a goal for some steps, a reward
/// kRewardPerArea for what each m2 is worth that is new on the true map. Episodes end with their
/// steps. An episode's score is the m2 that it saw. Source of the reward: the released code of
/// Active Neural SLAM.
class ExplorationLanes final : public PolicyTask {
 public:
  /// `scenes` and `pool` must outlive it.
  ExplorationLanes(int lanes, const MapSimulatorSpec& spec, const ExplorationScenes* scenes,
                   sim::WorkerPool* pool);

  int lanes() const override { return static_cast<int>(lanes_.size()); }
  int actions() const override { return 4; }           // means and logarithms of deviations
  int observation_size() const override { return 1; }  // the bin of the heading
  std::size_t picture_bytes() const override;          // of an exploration view
  bool shows_goals() const override { return false; }

  void Begin(int lane, std::uint64_t episode) override;
  void Observe(std::span<float> numbers, std::span<std::uint8_t> pictures) override;
  void Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) override;
  /// A lane's episode and its goals so far.
  std::vector<float> State() const override;
  /// Walks to the same goals again.
  void SetState(std::span<const float> state) override;

 private:
  struct Lane {
    std::uint64_t episode = 0;
    std::vector<agent::GoalSteps> goals;
    std::unique_ptr<MapSimulator> simulator;
  };
  LaneOutcome Walk(Lane* lane, const agent::GoalSteps& goal) const;

  MapSimulatorSpec spec_;
  const ExplorationScenes* scenes_;
  sim::WorkerPool* pool_;
  std::vector<Lane> lanes_;
};

}  // namespace bulletnav::bench
