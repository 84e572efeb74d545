// SPDX-License-Identifier: MIT
#include <utility>

#include "agent/models/semantic_model.h"
#include "agent/policy/policy_file.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/base/statistics.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/lane_groups.h"
#include "benchmark/training/rl/navigation/lane_training.h"
#include "benchmark/training/rl/navigation/navigation_plan.h"
#include "benchmark/training/rl/rollout.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

struct DistillationConfig : TrainPlan {
  NavigationPlan navigation;  // policy_start: whom it learns from
  int lanes = 64;
  int group = 8;    // lanes that are learned from together
  int rollout = 4;  // steps of each lane in a step of the training
  double gradient_norm = 1.0;

  template <class V>
  void Visit(V& v) {
    TrainPlan::Visit(v);
    navigation.Visit(v);
    v("lanes", lanes);
    v("group", group);
    v("rollout", rollout);
    v("gradient_norm", gradient_norm);
  }
  bool heeds_device() const { return false; }  // groups of lanes are on processors
  void Validate() const {
    TrainPlan::Validate();
    navigation.Validate();
    internal::RequireAtLeast(1, rollout, "rollout");
    internal::RequireAtLeast(1, lanes, "lanes");
    RequireGroups(lanes, group, 1);
    if (!(gradient_norm > 0.0)) {
      throw sim::KeyError("gradient_norm", "gradient_norm must be positive");
    }
    if (navigation.setting != LaneSetting::kRgb) {
      throw sim::KeyError("setting", "what is distilled is sight from colour: setting: rgb");
    }
    if (!navigation.model.own_encoder) {
      throw sim::KeyError("model", "the encoder is what learns: model: {own_encoder: true}");
    }
    if (!navigation.policy_start) {
      throw sim::KeyError("policy_start",
                          "policy_start is missing: it names the policy with depth to learn from");
    }
  }
};

/// The shape of the policy that is learned from. Throws Error.
agent::PolicyConfig GuideOf(const std::string& weights) {
  const std::filesystem::path file = ShippedOr(weights);
  const agent::PolicyConfig config = agent::PolicyConfigOf(agent::ReadTensorFile(file), file);
  if (config.own_encoder || config.map) {
    throw sim::KeyError("policy_start",
                        "what is learned from must be a policy that is shown no map and sees with "
                        "an encoder in integers (own_encoder: false)");
  }
  return config;
}

/// An encoder learns to see from colour alone what a policy with depth sees. That policy, the
/// guide, walks as its agent does; the encoder answers with the codes that the guide's makes of the
/// same panoramas. All other layers are the guide's, and stay as they are.
/// Source: Gupta, Hoffman and Malik, "Cross modal distillation for supervision transfer", CVPR
/// 2016.
class DistillationTraining final : public LaneTraining {
 public:
  static constexpr std::string_view kName = "distillation";
  using Config = DistillationConfig;

  DistillationTraining(const Config& config, const TrainContext& context)
      : LaneTraining(Checked(config.navigation), {config.lanes, config.group, config.rollout},
                     context),
        config_(config),
        guide_(MakeGuide()) {
    TakeNet([config] {
      return Make(config);
    });
    TakeLanes(Lanes(), guide_.get(), config.seed);
  }

  double Learn(const TrainStep& step) override {
    PlaySpec play;
    play.steps = config_.rollout;
    play.pictures = true;
    play.values = false;
    lanes()->StartRollout(1.0 * step.step / config_.steps);
    const Rollout rollout = actor()->Play(play, {});
    const std::vector<double> missed =
        groups()->Differentiate(AllGroups(), [&](int group, ActorCritic* net) {
          return Missed(rollout, groups()->LanesOf(group), net);
        });
    LimitGradients(net(), config_.gradient_norm);
    step.optimiser->Step(step.rate);
    missed_ = Mean(missed);
    return missed_;
  }

  std::string title() const override {
    return "A policy that sees from colour what one with depth sees";
  }

 private:
  /// Tells of a guide that will not do before scenes are loaded.
  static const NavigationPlan& Checked(const NavigationPlan& plan) {
    GuideOf(*plan.policy_start);
    return plan;
  }

  void AppendLearned(Measures* measures) const override { (*measures)("explained", 1.0 - missed_); }

  static std::unique_ptr<PictureNet> Make(const Config& config) {
    std::unique_ptr<PictureNet> net = config.navigation.MakeNet(config.seed);
    net->HideDepth();
    return net;
  }

  std::unique_ptr<PictureNet> MakeGuide() const {
    NavigationPlan plan = config_.navigation;
    plan.model = GuideOf(*plan.policy_start);
    plan.encoder = plan.policy_start;
    std::unique_ptr<PictureNet> guide = plan.MakeNet(config_.seed);
    guide->StopFrom(plan.agent.stop_from);
    return guide;
  }

  NavigationSpec Lanes() const {
    NavigationSpec spec = config_.navigation.Lanes(Share());
    spec.setting = LaneSetting::kRgbd;  // for the guide
    spec.task.depth = true;
    return spec;
  }

  /// The share of the variance of the guide's codes that a net's codes miss.
  static torch::Tensor Missed(const Rollout& rollout, const torch::Tensor& lanes,
                              ActorCritic* net) {
    const auto of = [&](const torch::Tensor& all) {
      return all.index_select(1, lanes).flatten(0, 1);
    };
    const torch::Tensor wanted = of(rollout.codes).view({-1, agent::kCodeSize});
    const torch::Tensor codes = net->Encode(of(rollout.pictures)).view({-1, agent::kCodeSize});
    const torch::Tensor spread = (wanted - wanted.mean(0)).square().mean();
    return (codes - wanted).square().mean() / spread.clamp_min(1e-12);
  }

  Config config_;
  std::unique_ptr<PictureNet> guide_;
  double missed_ = 1.0;
};

const TrainerRegistration<DistillationTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
