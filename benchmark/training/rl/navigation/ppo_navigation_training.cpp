// SPDX-License-Identifier: MIT
#include <map>
#include <utility>

#include "benchmark/base/shipped_file.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/navigation/navigation_plan.h"
#include "benchmark/training/rl/ppo_training.h"

namespace bulletnav::bench {
namespace {

struct PpoNavigationConfig : PpoPlan {
  NavigationPlan navigation;

  template <class V>
  void Visit(V& v) {
    PpoPlan::Visit(v);
    navigation.Visit(v);
  }
  void Validate() const {
    PpoPlan::Validate();
    navigation.Validate();
  }
};

/// A policy that learns to reach image goals by reward: 10 SPL at success, the decrease of geodesic
/// distance, and -0.001 a step. Source: Neural Topological SLAM, section 5.1, "Target-driven RL".
class PpoNavigationTraining final : public PpoTraining {
 public:
  static constexpr std::string_view kName = "ppo";
  using Config = PpoNavigationConfig;

  PpoNavigationTraining(const Config& config, const TrainContext& context)
      : PpoNavigationTraining(
            config,
            std::make_shared<NavigationWorld>(
                config.navigation.GoingOn(),
                RolloutSize{Share(config.ppo, context.peers.get()).lanes, config.ppo.rollout},
                context),
            context.peers) {}

  Measures Validate() override {
    Measures measures = world_->Validate(net_of_policy().policy(), pool());
    AppendReport(&measures);
    return measures;
  }
  std::string frames_are() const override { return "frames"; }
  std::int64_t FramesBefore() const override { return world_->frames_before(); }
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override {
    agent::SavePolicy(*net_of_policy().policy(), WithReturns(std::move(notes)),
                      agent::StoredType::kBfloat16, file);
  }
  std::optional<Measures> Quantise(const std::filesystem::path& file) override {
    std::optional<Measures> measures =
        world_->Quantise(net_of_policy().policy().get(), file, pool());
    if (measures) AppendReport(&*measures);
    return measures;
  }
  std::string title() const override { return "A policy that learns image goals by reward"; }
  std::string Describe(const Measures& measures) const override {
    return DescribeNavigation(measures);
  }
  std::string curves_label() const override { return "success, validation"; }
  std::vector<CurveLine> curves() const override {
    return NavigationCurves(config_.navigation.setting);
  }
  std::vector<std::pair<std::string, std::string>> CardRows() const override {
    return world_->CardRows(config_.ppo.lanes, config_.ppo.rollout);
  }
  std::string validated_on() const override { return world_->validated_on(); }

 private:
  PpoNavigationTraining(const Config& config, const std::shared_ptr<NavigationWorld>& world,
                        const std::shared_ptr<Peers>& peers)
      : PpoTraining(
            config,
            [config] {
              return config.navigation.MakeNet(config.seed);
            },
            [config, world, peers](sim::WorkerPool* pool) {
              const LaneShare share = Share(config.ppo, peers.get());
              return std::make_unique<NavigationLanes>(config.navigation.Lanes(share),
                                                       world->scenes(), pool);
            },
            peers),
        config_(config),
        world_(world) {
    if (config.navigation.policy_start) TakeReturns(ShippedOr(*config.navigation.policy_start));
  }

  const PictureNet& net_of_policy() const { return dynamic_cast<const PictureNet&>(policy()); }

  Config config_;
  std::shared_ptr<NavigationWorld> world_;
};

const TrainerRegistration<PpoNavigationTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
