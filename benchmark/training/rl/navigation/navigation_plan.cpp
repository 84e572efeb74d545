// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/navigation_plan.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/perception/quantise.h"
#include "agent/policy/integer_policy.h"
#include "agent/policy/learned_policy.h"
#include "agent/policy/policy_file.h"
#include "agent/policy/restore_policy.h"
#include "benchmark/base/memory.h"
#include "benchmark/base/program_version.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/base/warn_line.h"
#include "sim/base/error.h"
#include "sim/sensors/noise/sensor_noise.h"

namespace bulletnav::bench {
namespace {

std::vector<std::pair<std::string, std::string>> SettingsOf(LaneSetting setting) {
  if (setting == LaneSetting::kRgb) return {{"rgb", ""}};
  if (setting == LaneSetting::kRgbd) return {{"rgbd", ""}};
  return {{"rgb", "rgb_"}, {"rgbd", "rgbd_"}};
}

}  // namespace

NavigationScenes LoadNavigationScenes(const NavigationData& data, const TrainContext& context,
                                      const char* what, int threads) {
  MakeHousesOf(data, CommittedVersion(), threads, context.start);
  std::function<void()> loaded;
  if (context.start) {
    loaded = context.start(what, static_cast<int>(ScenesOf(data).size()));
  }
  return NavigationScenes(data, sim::BodySpec{}, threads, loaded, WarnLine);
}

void NavigationPlan::Validate() const {
  internal::RequireAtLeast(1, validation_episodes, "validation_episodes");
  if (!(averaged_from >= 0.0 && averaged_from <= 1.0)) {
    throw sim::KeyError("averaged_from", "averaged_from must be in [0, 1]");
  }
  if (model.map && setting != LaneSetting::kRgbd) {
    throw sim::KeyError("setting", "a policy that is shown a map needs setting: rgbd");
  }
  sim::RequireSensorNoise(sensor_noise.value_or("none"));
  if (!model.own_encoder && !encoder) {
    throw sim::KeyError("encoder",
                        "encoder is missing: with own_encoder: false it names the weights of a "
                        "semantic model to see with");
  }
}

Task NavigationPlan::task() const {
  Task task;
  task.depth = setting != LaneSetting::kRgb;
  task.noise = noise;
  task.sensor_noise = sim::NamedSensorNoise(sensor_noise.value_or("none"));
  task.max_steps = model.step_limit;
  task.reward = RewardSpec{};
  return task;
}

NavigationSpec NavigationPlan::Lanes(const LaneShare& share) const {
  NavigationSpec spec;
  spec.lanes = share.lanes;
  spec.first_lane = share.first;
  spec.rows = model.rows;
  spec.setting = setting;
  spec.map = model.map;
  spec.draw = draw;
  spec.averaged_from = averaged_from;
  spec.task = task();
  return spec;
}

void NavigationPlan::RequireRollout(const RolloutSize& size) const {
  constexpr double kTwice = 2.0;  // while steps are put together
  const double codes = sizeof(float) * static_cast<double>(agent::PolicyNet::CodeSize(model));
  const double step =
      model.own_encoder ? static_cast<double>(agent::PolicyNet::PictureBytes(model)) : codes;
  RequireMemory(kTwice * step * size.steps * size.lanes,
                fmt::format("a rollout of {} steps in {} lanes", size.steps, size.lanes),
                "take a shorter rollout or fewer lanes");
}

const NavigationPlan& NavigationPlan::GoingOn() const {
  if (!policy_start) return *this;
  const std::filesystem::path file = ShippedOr(*policy_start);
  const agent::TensorFile weights = agent::ReadTensorFile(file);
  agent::PolicyConfigOf(weights, file);
  if (setting != LaneSetting::kBoth) {
    agent::RequireTrainedSetting(std::string(sim::NameOf(setting)), weights, file);
  }
  return *this;
}

std::unique_ptr<PictureNet> NavigationPlan::MakeNet(std::uint64_t seed) const {
  std::optional<std::string> seeing;
  if (encoder) seeing = ShippedOr(*encoder).string();
  auto net = std::make_unique<PictureNet>(model, seeing, seed);
  if (policy_start) agent::TakePolicy(ShippedOr(*policy_start), net->policy().get());
  return net;
}

NavigationWorld::NavigationWorld(const NavigationPlan& plan, const RolloutSize& rollout,
                                 const TrainContext& context)
    : setting_(plan.setting),
      validation_episodes_(plan.validation_episodes),
      agent_(plan.agent),
      frames_before_(
          plan.policy_start ? agent::FramesTrained(ShippedOr(*plan.policy_start)).value_or(0) : 0),
      peers_(context.peers),
      scenes_([&] {
        plan.RequireRollout(rollout);
        return LoadNavigationScenes(plan.data, context, "loading scenes");
      }()),
      validation_scenes_(LoadNavigationScenes(ValidationOf(plan.validation, plan.data), context,
                                              "loading validation scenes")),
      validation_(&validation_scenes_, plan.task(), plan.validation_episodes) {}

Measures NavigationWorld::Validate(const std::shared_ptr<agent::PolicyNet>& net,
                                   sim::WorkerPool* pool) const {
  return Validate(
      [&net] {
        return std::make_shared<agent::LearnedPolicy>(net);
      },
      pool);
}

std::optional<Measures> NavigationWorld::Quantise(agent::PolicyNet* net,
                                                  const std::filesystem::path& file,
                                                  sim::WorkerPool* pool) const {
  if (!net->sight() && !agent::HasIntegerForm(net->config().seeing())) return std::nullopt;
  const agent::QuantisedNet quantised =
      agent::Quantise(net, validation_.Calibration(net->config(), setting_));
  if (!peers_ || peers_->is_first()) {
    agent::AddQuantised(quantised, file, file, agent::RestoredNumbers(quantised));
  }
  const agent::PolicyConfig config = net->config();
  return Validate(
      [&quantised, &config] {
        return std::make_shared<agent::IntegerPolicy>(config, quantised);
      },
      pool);
}

Measures NavigationWorld::Validate(const PolicyValidation::PolicyMaker& make,
                                   sim::WorkerPool* pool) const {
  Measures all;
  double success = 0.0;
  const auto settings = SettingsOf(setting_);
  for (const auto& [setting, prefix] : settings) {
    PolicyValidation::Way way{setting == "rgbd", prefix, pool, peers_.get()};
    way.agent = agent_;
    validation_.Measure(make, way, &all);
    success += all.at(prefix + "success") / static_cast<double>(settings.size());
  }
  Measures measures;
  measures("loss", 1.0 - success);
  for (const Measures::Item& item : all.items()) measures(item.name, item.value);
  return measures;
}

std::vector<std::pair<std::string, std::string>> NavigationWorld::CardRows(int lanes,
                                                                           int rollout) const {
  std::string scenes = std::to_string(scenes_.count());
  if (scenes_.plain_count() > 0) {
    scenes += fmt::format(", {} of them as they are, too", scenes_.plain_count());
  }
  return {{"scenes", scenes}, {"a step", fmt::format("{} steps of {} lanes", rollout, lanes)}};
}

std::string NavigationWorld::validated_on() const {
  return fmt::format("{} episodes in validation scenes, in each setting", validation_episodes_);
}

std::string DescribeNavigation(const Measures& measures) {
  std::string text;
  for (const Measures::Item& item : measures.items()) {
    const bool is_told = item.name.ends_with("success") || item.name.ends_with("spl") ||
                         item.name.ends_with("stopped") || item.name == "agreement" ||
                         item.name == "entropy" || item.name == "kl" ||
                         item.name == "explained_variance";
    if (is_told)
      text += fmt::format("{}{} {:.3f}", text.empty() ? "" : ", ", item.name, item.value);
  }
  return text;
}

std::vector<CurveLine> NavigationCurves(LaneSetting setting) {
  std::vector<CurveLine> lines;
  for (const auto& [name, prefix] : SettingsOf(setting)) {
    for (const char* kind : {"easy", "medium", "hard"}) {
      lines.push_back(
          {fmt::format("{}, {}", name, kind), fmt::format("{}success_{}", prefix, kind)});
    }
  }
  return lines;
}

}  // namespace bulletnav::bench
