// SPDX-License-Identifier: MIT
#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "agent/policy/policy_input.h"
#include "benchmark/play/environment.h"
#include "benchmark/privileged/shortest_path.h"
#include "benchmark/training/rl/navigation/navigation_scenes.h"
#include "benchmark/training/rl/policy_task.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// Which lanes are shown depth. kBoth: every second one, so that one network learns both settings.
enum class LaneSetting { kRgb, kRgbd, kBoth };

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::LaneSetting> {
  static constexpr std::array kNames = {std::pair{"rgb", bulletnav::bench::LaneSetting::kRgb},
                                        std::pair{"rgbd", bulletnav::bench::LaneSetting::kRgbd},
                                        std::pair{"both", bulletnav::bench::LaneSetting::kBoth}};
};

namespace bulletnav::bench {

struct NavigationSpec {
  int lanes = 32;
  int rows = 64;  // of the pictures that policies see
  LaneSetting setting = LaneSetting::kBoth;
  bool teaches = false;  // the shortest path's follower acts along, as a teacher
  Task task;
};

/// Image-goal navigation for a policy: the task that runs are played in, with noise, shown as
/// policies see it. An episode's score is its SPL.
class NavigationLanes final : public PolicyTask {
 public:
  /// `scenes` and `pool` must outlive it.
  NavigationLanes(const NavigationSpec& spec, NavigationScenes* scenes, sim::WorkerPool* pool);

  int lanes() const override { return spec_.lanes; }
  int actions() const override { return 4; }
  int observation_size() const override { return agent::kPolicyNumbers; }
  std::size_t picture_bytes() const override;

  void Begin(int lane, std::uint64_t episode) override;
  void Observe(std::span<float> numbers, std::span<std::uint8_t> pictures) override;
  void ShowGoal(int lane, std::span<std::uint8_t> picture) const override;
  bool Teach(std::span<int> actions) override;
  void Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) override;
  /// A lane's episode and its actions so far.
  std::vector<float> State() const override;
  /// Takes the same steps again, without looking.
  void SetState(std::span<const float> state) override;

 private:
  struct Lane {
    std::uint64_t episode = 0;
    std::vector<sim::Action> taken;
    std::unique_ptr<agent::PolicyPictures> pictures;
    std::unique_ptr<ShortestPathAgent> teacher;
    std::optional<sim::Action> lesson;  // of where the body is now
  };
  agent::Panorama Shown(int lane, const agent::Panorama& panorama) const;
  LaneOutcome OutcomeOf(int lane, const StepOutcome& step) const;
  void AskTeacher(int lane);

  NavigationSpec spec_;
  NavigationScenes* scenes_;
  sim::WorkerPool* pool_;
  std::vector<GroundTruth> truths_;
  std::vector<Lane> lanes_;
  std::unique_ptr<Environment> environment_;
  std::vector<int> all_;
};

}  // namespace bulletnav::bench
