// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "agent/policy/policy_agent.h"
#include "agent/policy/policy_config.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/lane_groups.h"
#include "benchmark/training/rl/navigation/navigation_lanes.h"
#include "benchmark/training/rl/navigation/picture_net.h"
#include "benchmark/training/rl/navigation/policy_validation.h"

namespace bulletnav::bench {

/// What one process plays before it learns from it.
struct RolloutSize {
  int lanes = 0;
  int steps = 0;
};

/// What trainings of policies are told about the world and the net, beside how they learn.
struct NavigationPlan {
  NavigationData data;
  std::optional<NavigationData> validation;  // default: the houses' split "val"
  int validation_episodes = 60;              // in each setting
  agent::PolicyAgent::Config agent;          // of validation
  LaneSetting setting = LaneSetting::kBoth;
  sim::NoiseMode noise = sim::NoiseMode::kAnsReleased;
  std::optional<std::string> sensor_noise;  // of cameras, see sim::NamedSensorNoise; default: none
  DrawMode draw = DrawMode::kAveraged;  // of pictures in training; validation is always averaged
  double averaged_from = 0.9;           // share of the training after which it is, too
  agent::PolicyConfig model;
  std::optional<std::string> encoder;       // see PictureNet
  std::optional<std::string> policy_start;  // weights of a policy to go on from; default: none

  template <class V>
  void Visit(V& v) {
    v("data", data);
    v("validation", validation);
    v("validation_episodes", validation_episodes);
    v("agent", agent);
    v("setting", setting);
    v("noise", noise);
    v("sensor_noise", sensor_noise);
    v("draw", draw);
    v("averaged_from", averaged_from);
    v("model", model);
    v("encoder", encoder);
    v("policy_start", policy_start);
  }
  /// Throws Error.
  void Validate() const;

  Task task() const;                                   // as runs play it
  NavigationSpec Lanes(const LaneShare& share) const;  // without a teacher
  /// Throws sim::Error if a rollout of that size certainly does not fit into memory.
  void RequireRollout(const RolloutSize& size) const;
  /// This, if the policy of policy_start can go on in this setting. Throws FileError for a file of
  /// something else and for a policy that knows another setting alone.
  const NavigationPlan& GoingOn() const;
  std::unique_ptr<PictureNet> MakeNet(std::uint64_t seed) const;
};

/// Makes houses that are not there, and loads all scenes, by so many threads (0: one a processor).
/// `what` is told as it goes on. Throws Error.
NavigationScenes LoadNavigationScenes(const NavigationData& data, const TrainContext& context,
                                      const char* what, int threads = 0);

/// The scenes and episodes that a policy is trained and tried in.
class NavigationWorld {
 public:
  /// Makes houses that are not there, and loads all scenes. Throws Error; first of all for a
  /// rollout that does not fit.
  NavigationWorld(const NavigationPlan& plan, const RolloutSize& rollout,
                  const TrainContext& context);

  NavigationScenes* scenes() { return &scenes_; }
  /// "success" and all others of PolicyValidation; after "rgb_" and "rgbd_" if both are trained.
  /// "loss": what success lacks of 1, the mean of the settings.
  Measures Validate(const std::shared_ptr<agent::PolicyNet>& net, sim::WorkerPool* pool) const;
  /// Puts the policy in integers into a file of its weights, and tells how it fares. Scales are
  /// from the validation's first steps. Absent for a width that has no integers. Of several
  /// processes, which share the episodes, the first writes.
  std::optional<Measures> Quantise(agent::PolicyNet* net, const std::filesystem::path& file,
                                   sim::WorkerPool* pool) const;
  /// Rows of a card: the scenes, and a step of the training.
  std::vector<std::pair<std::string, std::string>> CardRows(int lanes, int rollout) const;
  std::string validated_on() const;
  std::int64_t frames_before() const { return frames_before_; }  // see Training::FramesBefore

 private:
  Measures Validate(const PolicyValidation::PolicyMaker& make, sim::WorkerPool* pool) const;

  LaneSetting setting_;
  int validation_episodes_;
  agent::PolicyAgent::Config agent_;
  std::int64_t frames_before_;
  std::shared_ptr<Peers> peers_;  // or null
  NavigationScenes scenes_;
  NavigationScenes validation_scenes_;
  PolicyValidation validation_;
};

/// A validation in a line.
std::string DescribeNavigation(const Measures& measures);
std::vector<CurveLine> NavigationCurves(LaneSetting setting);

}  // namespace bulletnav::bench
