// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "agent/policy/policy_input.h"
#include "agent/policy/policy_map.h"
#include "benchmark/play/environment.h"
#include "benchmark/privileged/shortest_path.h"
#include "benchmark/training/rl/navigation/navigation_scenes.h"
#include "benchmark/training/rl/policy_task.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// Which lanes are shown depth. kBoth: every second one, so that one network learns both settings.
enum class LaneSetting { kRgb, kRgbd, kBoth };

/// How the pictures that a policy sees are made: as in runs, averages over squares of panoramas of
/// 128 x 512, or drawn in the policy's own size, which takes less time and has sharper edges.
enum class DrawMode { kAveraged, kDirect };

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::LaneSetting> {
  static constexpr std::array kNames = {std::pair{"rgb", bulletnav::bench::LaneSetting::kRgb},
                                        std::pair{"rgbd", bulletnav::bench::LaneSetting::kRgbd},
                                        std::pair{"both", bulletnav::bench::LaneSetting::kBoth}};
};
template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::DrawMode> {
  static constexpr std::array kNames = {
      std::pair{"averaged", bulletnav::bench::DrawMode::kAveraged},
      std::pair{"direct", bulletnav::bench::DrawMode::kDirect}};
};

namespace bulletnav::bench {

struct NavigationSpec {
  int lanes = 32;
  int first_lane = 0;  // of all lanes that are trained in, see PolicyTask
  int rows = 64;       // of the pictures that policies see
  LaneSetting setting = LaneSetting::kBoth;
  /// Metres of way left at which a teacher stops, the shortest path's follower, who acts along;
  /// absent: no teacher.
  std::optional<double> teacher_stops;
  bool map = false;  // policies are shown a metric map; the setting must be kRgbd
  DrawMode draw = DrawMode::kAveraged;
  double averaged_from = 0.9;  // of a training by kDirect: episodes that begin later are kAveraged
  Task task;
};

/// The task with its panoramas drawn in that way for policies that see so many rows.
Task Drawn(Task task, DrawMode draw, int rows);

/// What a policy is told of the body that it steers in a task.
agent::Rig RigOf(const Task& task);

/// Image-goal navigation for a policy: the task that runs are played in, with noise, shown as
/// policies see it. An episode's score is its SPL. Policies are told how many of their steps are
/// gone (agent::WritePolicyNumbers), so that one that ran out of them has terminated: nothing more
/// was to be had. Source: Pardo et al., "Time limits in reinforcement learning", 2018.
class NavigationLanes final : public PolicyTask {
 public:
  /// `scenes` and `pool` must outlive it.
  NavigationLanes(const NavigationSpec& spec, NavigationScenes* scenes, sim::WorkerPool* pool);

  int lanes() const override { return spec_.lanes; }
  int first_lane() const override { return spec_.first_lane; }
  int actions() const override { return 4; }
  int observation_size() const override { return agent::kPolicyNumbers; }
  /// Of PolicyPictures, and of PolicyMap after them.
  std::size_t picture_bytes() const override;

  void StartRollout(double done) override;
  void Begin(int lane, std::uint64_t episode) override;
  void Observe(std::span<float> numbers, std::span<std::uint8_t> pictures) override;
  void ShowGoal(int lane, std::span<std::uint8_t> picture) const override;
  bool Teach(std::span<Lesson> lessons) override;
  void Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) override;
  /// A lane's episode, how it is drawn, and its actions so far.
  std::vector<float> State() const override;
  /// Takes the same steps again, and looks only where there is a map.
  void SetState(std::span<const float> state) override;

 private:
  /// A world of bodies whose panoramas are drawn in one way; lanes that are not in it are empty.
  struct Stage {
    Stage(const Task& task, int lanes, int threads);
    Task task;
    std::vector<GroundTruth> truths;
    Environment environment;
  };
  struct Lane {
    std::uint64_t episode = 0;
    DrawMode draw = DrawMode::kAveraged;
    Stage* stage = nullptr;
    std::vector<sim::Action> taken;
    std::unique_ptr<agent::PolicyPictures> pictures;
    std::unique_ptr<agent::PolicyMap> map;
    std::optional<std::size_t> mapped;  // actions before what the map last saw
    std::unique_ptr<ShortestPathAgent> teacher;
    std::optional<Lesson> lesson;  // of where the body is now
  };
  Lane& at(int lane) { return lanes_[static_cast<std::size_t>(lane)]; }
  const Lane& at(int lane) const { return lanes_[static_cast<std::size_t>(lane)]; }
  Stage* StageOf(DrawMode draw);
  void Enter(int lane, DrawMode draw);
  void Start(int lane, std::uint64_t episode, DrawMode draw);
  agent::Panorama Shown(int lane, const agent::Panorama& panorama) const;
  void Look(std::span<const int> lanes);
  void Map(int lane);
  void Move(std::span<const int> lanes, std::span<const sim::Action> actions,
            std::span<LaneOutcome> outcomes);
  LaneOutcome OutcomeOf(int lane, const StepOutcome& step) const;
  void AskTeacher(int lane);

  NavigationSpec spec_;
  NavigationScenes* scenes_;
  sim::WorkerPool* pool_;
  std::array<std::unique_ptr<Stage>, 2> stages_;  // by DrawMode, made when they are needed
  DrawMode draw_;                                 // of episodes that begin now
  std::vector<Lane> lanes_;
  std::vector<int> all_;
};

}  // namespace bulletnav::bench
