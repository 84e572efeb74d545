// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "agent/mapping/map_navigator.h"
#include "agent/policy/exploration_policy.h"
#include "benchmark/training/rl/exploration/coarse_planner.h"
#include "benchmark/training/rl/exploration/exploration_scenes.h"
#include "benchmark/training/rl/exploration/viewshed.h"
#include "sim/math/rng.h"
#include "sim/noise/noise_model.h"
#include "sim/physics/capsule_body.h"

namespace bulletnav::bench {

struct MapSimulatorSpec {
  int goal_steps = 25;      // steps between goals
  int episode_steps = 500;  // a multiple of these
  /// Share of the odometry's error that is left when scans have mended it (see agent::ScanMatch):
  /// in three furnished houses, .03 to .10 of it after 100 steps.
  double odometry_kept = 0.1;
  sim::NoiseMode noise = sim::NoiseMode::kAnsReleased;
  /// Metres. A m2 of floor at a distance d from the start that is farther than this is worth
  /// (near_start / d)^2 of one, as image goals are: bands of distance hold as many each, and the
  /// farther ones are spread over more floor. Absent: all floor is worth the same.
  std::optional<double> near_start;

  template <class V>
  void Visit(V& v) {
    v("goal_steps", goal_steps);
    v("episode_steps", episode_steps);
    v("odometry_kept", odometry_kept);
    v("noise", noise);
    v("near_start", near_start);
  }
  /// Throws Error.
  void Validate() const;
  int decisions() const { return episode_steps / goal_steps; }
};

/// A body that explores by long-term goals on a metric map, without pictures: Bullet's body with
/// the noise of runs, the agents' own map of what a Viewshed shows, and the agents' local policy on
/// coarser plans. What happens is a function of scene, start, key and goals.
/// Cost of a step: about 0.3 ms.
class MapSimulator {
 public:
  explicit MapSimulator(const MapSimulatorSpec& spec);

  /// Throws PoseError if the body cannot stand there. `seed`: of the noise. The scene must outlive
  /// the episode.
  void Begin(const ExplorationScene& scene, const sim::BodyPose& start, std::uint64_t seed);

  /// Walks towards a goal in the present window for goal_steps steps. Returns what the floor is
  /// worth that was seen for the first time. A goal that has been reached is waited at.
  double Walk(const agent::GoalSteps& goal);
  /// The same by the nearest frontiers, as metric_map_fbe explores; to compare with.
  double WalkToFrontiers();

  /// What the policy sees; see WriteExplorationView.
  void Show(std::span<std::uint8_t> view) const;
  int heading() const;

  int steps() const { return steps_; }
  bool is_over() const { return steps_ >= spec_.episode_steps; }
  /// m2 seen since Begin, on the true map.
  double explored() const;
  /// The same, of floor near the start: see MapSimulatorSpec::near_start.
  double worth() const;
  int collisions() const { return collisions_; }
  const agent::MapNavigator& navigator() const { return navigator_; }
  const sim::BodyPose& true_pose() const { return body_->pose(); }

 private:
  sim::Action Choose(const agent::Point& goal, bool plans);
  sim::Action ChooseByFrontier();
  void Step(sim::Action action);

  MapSimulatorSpec spec_;
  sim::BodySpec body_spec_;
  sim::NoiseModel noise_;
  std::unique_ptr<Viewshed> made_view_;  // until the navigator has it
  Viewshed* view_;
  agent::MapNavigator navigator_;
  CoarsePlanner planner_;
  const ExplorationScene* scene_ = nullptr;
  std::unique_ptr<sim::CapsuleBody> body_;
  SeenGround seen_;
  std::uint64_t seed_ = 0;
  int steps_ = 0;
  int collisions_ = 0;
  bool was_hindered_ = false;  // in the last step
};

}  // namespace bulletnav::bench
