// SPDX-License-Identifier: MIT
#include <array>
#include <map>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "agent/integer/quantised_file.h"
#include "agent/policy/exploration_view.h"
#include "agent/policy/integer_exploration.h"
#include "agent/policy/quantise_exploration.h"
#include "benchmark/base/program_version.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/exploration/exploration_lanes.h"
#include "benchmark/training/rl/exploration/exploration_validation.h"
#include "benchmark/training/rl/exploration/goal_net.h"
#include "benchmark/training/rl/navigation/navigation_scenes.h"
#include "benchmark/training/rl/ppo_training.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr int kCalibrationEpisodes = 8;

/// The deviation of goals along the training, instead of a learned one: from one to the other, by
/// the same factor in each step.
struct DeviationSchedule {
  double from = 1.0;
  double to = 0.3;

  template <class V>
  void Visit(V& v) {
    v("from", from);
    v("to", to);
  }
  void Validate() const {
    if (!(from > 0.0 && from <= 10.0)) throw sim::KeyError("from", "from must be in (0, 10]");
    if (!(to > 0.0 && to <= 10.0)) throw sim::KeyError("to", "to must be in (0, 10]");
  }
  double At(int step, int steps) const {
    const double share = steps <= 1 ? 1.0 : static_cast<double>(step) / (steps - 1);
    return from * sim::Exp(share * sim::Log(to / from));
  }
};

struct ExplorationPlan : PpoPlan {
  NavigationData data;
  std::optional<NavigationData> validation;  // default: the houses' split "val"
  int validation_episodes = 24;
  MapSimulatorSpec simulator;
  agent::ExplorationConfig model;
  std::optional<DeviationSchedule> deviation;  // absent: it is learned

  template <class V>
  void Visit(V& v) {
    PpoPlan::Visit(v);
    v("data", data);
    v("validation", validation);
    v("validation_episodes", validation_episodes);
    v("simulator", simulator);
    v("model", model);
    v("deviation", deviation);
  }
  void Validate() const {
    PpoPlan::Validate();
    internal::RequireAtLeast(1, validation_episodes, "validation_episodes");
  }
  bool heeds_steps() const {
    return optimiser.schedule != Schedule::kConstant || deviation.has_value();
  }
};

ExplorationScenes LoadScenes(const NavigationData& data, const TrainContext& context,
                             const char* what) {
  MakeHousesOf(data, CommittedVersion(), 0, context.start);
  const std::vector<std::filesystem::path> files = ScenesOf(data);
  if (files.empty()) throw sim::KeyError("data", "data names no scenes; see configs/train");
  std::function<void()> loaded;
  if (context.start) loaded = context.start(what, static_cast<int>(files.size()));
  return {files, data.import.options(), data.seed, 0, loaded};
}

/// The scenes that a policy is trained and tried in.
struct ExplorationWorld {
  ExplorationWorld(const ExplorationPlan& plan, const TrainContext& context)
      : scenes(LoadScenes(plan.data, context, "loading scenes")),
        validation_scenes(LoadScenes(ValidationOf(plan.validation, plan.data), context,
                                     "loading validation scenes")),
        validation(&validation_scenes, plan.simulator, plan.validation_episodes) {}

  ExplorationScenes scenes;
  ExplorationScenes validation_scenes;
  ExplorationValidation validation;
};

/// The global policy of Active Neural SLAM, trained by PPO in a simulator of maps. Source: Chaplot
/// et al., "Learning to explore using Active Neural SLAM", 2020.
class ExplorationTraining final : public PpoTraining {
 public:
  static constexpr std::string_view kName = "exploration";
  using Config = ExplorationPlan;

  ExplorationTraining(const Config& config, const TrainContext& context)
      : ExplorationTraining(config, std::make_shared<ExplorationWorld>(config, context)) {}

  double Learn(const TrainStep& step) override {
    if (config_.deviation) {
      goal_net().SetDeviation(config_.deviation->At(step.step, config_.steps));
    }
    return PpoTraining::Learn(step);
  }
  Measures Validate() override {
    const std::shared_ptr<agent::ExplorationNet> net = goal_net().policy();
    return Measure([net] {
      return std::make_shared<agent::LearnedExploration>(net);
    });
  }
  std::int64_t FramesAfter(int steps) const override {
    return PpoTraining::FramesAfter(steps) * config_.simulator.goal_steps;
  }
  std::string frames_are() const override { return "frames of the map simulator"; }
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override {
    agent::SaveExploration(*dynamic_cast<const GoalNet&>(policy()).policy(), std::move(notes),
                           agent::StoredType::kBfloat16, file);
  }
  std::optional<Measures> Quantise(const std::filesystem::path& file) override {
    const std::shared_ptr<agent::ExplorationNet> net = goal_net().policy();
    const std::vector<std::uint8_t> views = world_->validation.Views(
        [net] {
          return std::make_shared<agent::LearnedExploration>(net);
        },
        kCalibrationEpisodes);
    torch::Tensor bytes = torch::empty({static_cast<std::int64_t>(views.size())}, torch::kUInt8);
    std::copy(views.begin(), views.end(), bytes.data_ptr<std::uint8_t>());
    const agent::QuantisedNet quantised = agent::Quantise(
        net.get(), bytes.view({-1, static_cast<std::int64_t>(agent::kExplorationBytes)}));
    agent::AddQuantised(quantised, file, file);
    const float* deviation = net->log_deviation().data_ptr<float>();
    return Measure([&quantised, net, deviation] {
      return std::make_shared<agent::IntegerExploration>(net->config(), quantised,
                                                         std::span(deviation, 2));
    });
  }
  std::string title() const override { return "An exploration policy of Active Neural SLAM"; }
  std::string Describe(const Measures& measures) const override {
    return fmt::format(
        "explored {:.1f} m2 (goals at random {:.1f}, frontiers {:.1f}), early {:.1f} ({:.1f}, "
        "{:.1f}), sigma {:.2f}, entropy {:.2f}, KL {:.4f}, "
        "explained variance {:.2f}",
        measures.at("explored"), measures.at("explored_at_random"),
        measures.at("explored_by_frontiers"), measures.at("early"), measures.at("early_at_random"),
        measures.at("early_by_frontiers"), measures.at("deviation"), measures.at("entropy"),
        measures.at("kl"), measures.at("explained_variance"));
  }
  std::string curves_label() const override { return "m2 explored, validation"; }
  std::vector<CurveLine> curves() const override {
    return {{"the policy's goals", "explored"},
            {"goals at random", "explored_at_random"},
            {"frontiers", "explored_by_frontiers"}};
  }
  std::vector<std::pair<std::string, std::string>> CardRows() const override {
    return {{"scenes", std::to_string(world_->scenes.count())},
            {"simulator", "of maps, without pictures"},
            {"a step", fmt::format("{} goals of {} lanes, {} steps each", config_.ppo.rollout,
                                   config_.ppo.lanes, config_.simulator.goal_steps)}};
  }
  std::string validated_on() const override {
    return fmt::format("{} episodes of {} steps in validation scenes", config_.validation_episodes,
                       config_.simulator.episode_steps);
  }

 private:
  ExplorationTraining(const Config& config, const std::shared_ptr<ExplorationWorld>& world)
      : PpoTraining(
            config,
            [config] {
              return std::make_unique<GoalNet>(config.model, !config.deviation, config.seed);
            },
            [config, world](sim::WorkerPool* pool) {
              return std::make_unique<ExplorationLanes>(config.ppo.lanes, config.simulator,
                                                        &world->scenes, pool);
            }),
        config_(config),
        world_(world) {}

  GoalNet& goal_net() { return dynamic_cast<GoalNet&>(policy()); }

  /// "loss": the m2 explored, negative.
  Measures Measure(const ExplorationValidation::PolicyMaker& make) {
    const ExplorationValidation::Result result = world_->validation.Measure(make, pool());
    if (!at_random_) at_random_ = world_->validation.MeasureRandomGoals(pool());
    if (!by_frontiers_) by_frontiers_ = world_->validation.MeasureFrontiers(pool());
    Measures measures;
    measures("loss", -result.explored);
    measures("explored", result.explored);
    measures("explored_at_random", at_random_->explored);
    measures("explored_by_frontiers", by_frontiers_->explored);
    measures("early", result.early);
    measures("early_at_random", at_random_->early);
    measures("early_by_frontiers", by_frontiers_->early);
    measures("collisions", result.collisions);
    measures("deviation", sim::Exp(goal_net().policy()->log_deviation().mean().item<double>()));
    AppendReport(&measures);
    return measures;
  }

  Config config_;
  std::shared_ptr<ExplorationWorld> world_;
  // To compare with; made once.
  std::optional<ExplorationValidation::Result> at_random_;
  std::optional<ExplorationValidation::Result> by_frontiers_;
};

const TrainerRegistration<ExplorationTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
