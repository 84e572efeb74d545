// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "agent/observation.h"
#include "benchmark/play/ground_truth.h"
#include "benchmark/play/task_episode.h"
#include "sim/batch_simulator.h"
#include "sim/sensors/noise/picture_noise.h"

namespace bulletnav::bench {

/// Plays episodes of one task in several lanes at once: bodies, panoramas and accounts. The only
/// place that steps an episode; runs, training and whoever else plays are its clients:
///   environment.Reset(lane, episode, world);
///   while (!environment.is_over(lane)) {
///     if (environment.TakeNewGoal(lane)) { /* tell the agent: environment.goal(lane) */ }
///     environment.Observe({&lane, 1});
///     environment.Step({&lane, 1}, {/* what it makes of environment.observation(lane) */});
///   }
/// Lanes start and end by themselves. What happens in one is a function of the task, the episode
/// and the actions: not of other lanes, of threads, or of what was played before. Renderers are
/// kept as long as some lane is in their world.
class Environment {
 public:
  /// Keeps the truth about lane i in truths[i], which must outlive the environment; one lane for
  /// each. `threads` < 1: one per processor; 1: the calling thread.
  Environment(const Task& task, std::vector<GroundTruth*> truths, int threads);
  ~Environment();
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  Environment(Environment&&) = delete;
  Environment& operator=(Environment&&) = delete;

  int lanes() const { return static_cast<int>(lanes_.size()); }
  const Task& task() const { return task_; }

  /// Starts an episode. Throws sim::Error, naming the episode, if it cannot be played; the lane is
  /// then empty.
  void Reset(int lane, EpisodeTask episode, std::shared_ptr<const sim::World> world);
  /// Forgets the episode of a lane.
  void Clear(int lane);

  /// Whether there is an episode in the lane, over or not.
  bool has_episode(int lane) const { return at(lane).episode.has_value(); }
  bool is_over(int lane) const { return episode(lane).is_over(); }
  /// Whether the goal has changed since this was last asked.
  bool TakeNewGoal(int lane);
  bool is_first_goal(int lane) const { return episode(lane).goal() == 0; }
  /// The panorama of the present goal, or a picture as task().goal_camera says; lives until the
  /// goal changes.
  agent::Panorama goal(int lane) const;
  /// For the agent's random choices on the way to the present goal.
  std::uint64_t agent_seed(int lane) const { return episode(lane).agent_seed(); }

  /// Reads the sensors of some lanes.
  void Observe(std::span<const int> lanes);
  /// What they write, for one lane, and the memory of array number i of all lanes: [lanes,
  /// shape...]; it stays where it is.
  const std::vector<sim::ArraySpec>& arrays() const { return arrays_; }
  std::span<const std::byte> memory(std::size_t i) const { return memory_[i]; }
  /// What the lane's body senses. The panorama is the one last drawn, and lives until it is drawn
  /// again.
  agent::Observation observation(int lane) const;

  /// One action for each of some lanes, none of them over; outcomes in their order. Lives until
  /// the next call.
  std::span<const StepOutcome> Step(std::span<const int> lanes,
                                    std::span<const sim::Action> actions);
  /// The same, and reads the sensors of these lanes, rising, in one go of the threads: less to wait
  /// for than in Step and Observe.
  std::span<const StepOutcome> StepAndObserve(std::span<const int> lanes,
                                              std::span<const sim::Action> actions);

  /// Takes the agent off: the present goal and those after it are not reached.
  void Fail(int lane, const std::string& why);

  /// Expects: over (checked). `belief`: the agent's at the end.
  EpisodeTrajectory Finish(int lane, agent::Belief belief) const {
    return episode(lane).Finish(std::move(belief));
  }

 private:
  struct Lane {
    std::optional<TaskEpisode> episode;
    GroundTruth* truth = nullptr;
    bool has_new_goal = false;
    sim::Sensors sensors;
    std::vector<std::uint8_t> goal_color;
    std::vector<float> goal_depth;
    std::unique_ptr<sim::Renderer> goal_camera;  // of its world; made when it is needed
    std::vector<sim::ArrayView> arrays;          // in the memory below
  };
  Lane& at(int lane);
  const Lane& at(int lane) const;
  const TaskEpisode& episode(int lane) const;
  void Enter(int lane, const std::shared_ptr<const sim::World>& world);
  std::span<const StepOutcome> Advance(std::span<const int> lanes,
                                       std::span<const sim::Action> actions,
                                       const sim::BatchObservations& seen);
  void StartGoals(int lane);
  void DrawGoal(int lane);
  void DrawGoalPicture(Lane* lane, const sim::CameraPose& eye);
  sim::Rng GoalNoise(int lane) const;
  bool draws() const { return task_.color || task_.depth || task_.goal_camera; }
  void MakeMemory();

  Task task_;
  int threads_;
  std::vector<Lane> lanes_;
  std::vector<std::shared_ptr<const sim::World>> worlds_;  // of the simulator's lanes
  std::unique_ptr<sim::BatchSimulator> simulator_;         // made with the first world
  std::vector<std::uint8_t> color_;                        // [lanes, rows, cols, 3]
  std::vector<float> depth_;                               // [lanes, rows, cols]
  std::vector<sim::ArraySpec> arrays_;                     // of the sensors
  std::vector<std::vector<std::byte>> bytes_;              // of those that are not the panorama's
  std::vector<std::span<std::byte>> memory_;               // of all arrays
  std::vector<sim::BatchArray> others_;                    // `bytes_`, as the simulator takes them
  std::optional<sim::PictureNoise> goal_noise_;            // if there is any
  std::vector<sim::Sensors> read_;
  std::vector<StepOutcome> outcomes_;
};

}  // namespace bulletnav::bench
