// SPDX-License-Identifier: MIT
#include <map>
#include <numeric>
#include <utility>

#include "agent/models/semantic_model.h"
#include "agent/policy/policy_file.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/lane_groups.h"
#include "benchmark/training/rl/lanes_state.h"
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
  void Validate() const {
    TrainPlan::Validate();
    navigation.Validate();
    internal::RequireAtLeast(1, rollout, "rollout");
    internal::RequireAtLeast(1, lanes, "lanes");
    if (group < 1 || lanes % group != 0) throw sim::KeyError("group", "group must divide lanes");
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
class DistillationTraining final : public Training {
 public:
  static constexpr std::string_view kName = "distillation";
  using Config = DistillationConfig;

  DistillationTraining(const Config& config, const TrainContext& context)
      : config_(config),
        peers_(context.peers),
        guide_(MakeGuide()),
        world_(config.navigation, context),
        pool_(peers_ ? peers_->threads() : 0),
        net_(Make()),
        lanes_(std::make_unique<NavigationLanes>(Lanes(), world_.scenes(), &pool_)),
        groups_(
            config.lanes, config.group,
            [this] {
              return Make();
            },
            net_.get(), &pool_, peers_.get()),
        actor_(std::make_unique<Actor>(lanes_.get(), guide_.get(), &pool_, config.group,
                                       config.seed)) {}

  torch::nn::Module& net() override { return *net_; }
  bool shares_work() const override { return true; }

  double Learn(const TrainStep& step) override {
    PlaySpec play;
    play.steps = config_.rollout;
    play.pictures = true;
    play.values = false;
    lanes_->StartRollout(1.0 * step.step / config_.steps);
    const Rollout rollout = actor_->Play(play, {});
    std::vector<int> all(static_cast<std::size_t>(groups_.groups()));
    std::iota(all.begin(), all.end(), 0);
    const std::vector<double> missed = groups_.Differentiate(all, [&](int group, ActorCritic* net) {
      return Missed(rollout, groups_.LanesOf(group), net);
    });
    LimitGradients(*net_, config_.gradient_norm);
    step.optimiser->Step(step.rate);
    const double loss = std::accumulate(missed.begin(), missed.end(), 0.0);
    missed_ = loss / static_cast<double>(missed.size());
    return missed_;
  }

  Measures Validate() override {
    Measures measures = world_.Validate(net_->policy(), &pool_);
    measures("explained", 1.0 - missed_);
    return measures;
  }

  std::int64_t FramesAfter(int steps) const override {
    return std::int64_t{steps} * config_.lanes * config_.rollout;
  }
  std::int64_t FramesBefore() const override { return world_.frames_before(); }
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override {
    agent::SavePolicy(*net_->policy(), std::move(notes), agent::StoredType::kBfloat16, file);
  }
  void AppendState(agent::TensorFile* content) const override { AppendLanes(Ref(), content); }
  void SetState(const agent::TensorFile& content, const std::filesystem::path& file) override {
    SetLanes(content, file, Ref());
  }
  std::optional<Measures> Quantise(const std::filesystem::path& file) override {
    std::optional<Measures> measures = world_.Quantise(net_->policy().get(), file, &pool_);
    if (measures) (*measures)("explained", 1.0 - missed_);
    return measures;
  }
  std::string title() const override {
    return "A policy that sees from colour what one with depth sees";
  }
  std::string Describe(const Measures& measures) const override {
    return DescribeNavigation(measures);
  }
  std::string curves_label() const override { return "success, validation"; }
  std::vector<CurveLine> curves() const override {
    return NavigationCurves(config_.navigation.setting);
  }
  std::vector<std::pair<std::string, std::string>> CardRows() const override {
    return world_.CardRows(config_.lanes, config_.rollout);
  }
  std::string validated_on() const override { return world_.validated_on(); }

 private:
  LanesRef Ref() const { return {lanes_.get(), actor_.get(), peers_.get()}; }

  std::unique_ptr<PictureNet> Make() const {
    std::unique_ptr<PictureNet> net = config_.navigation.MakeNet(config_.seed);
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
    NavigationSpec spec =
        config_.navigation.Lanes(ShareOf(config_.lanes, config_.group, 1, peers_.get()), false);
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
  std::shared_ptr<Peers> peers_;
  std::unique_ptr<PictureNet> guide_;
  NavigationWorld world_;
  sim::WorkerPool pool_;
  std::unique_ptr<PictureNet> net_;
  std::unique_ptr<NavigationLanes> lanes_;
  LaneGroups groups_;
  std::unique_ptr<Actor> actor_;
  double missed_ = 1.0;
};

const TrainerRegistration<DistillationTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
