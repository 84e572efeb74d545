// SPDX-License-Identifier: MIT
#include <cstdint>
#include <vector>

#include "benchmark/base/statistics.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/lane_groups.h"
#include "benchmark/training/rl/navigation/imitation_loss.h"
#include "benchmark/training/rl/navigation/lane_training.h"
#include "benchmark/training/rl/navigation/navigation_plan.h"
#include "benchmark/training/rl/rollout.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

/// The share of episodes in which the teacher acts, along the training: 1 until `from`, then down
/// in a line to `least` at `to`. In the others the policy acts, and the teacher says what it would
/// have done there. Source: Ross, Gordon and Bagnell, "A reduction of imitation learning and
/// structured prediction to no-regret online learning", 2011 (DAgger).
struct DaggerSpec {
  int from = 0;  // steps of the training
  int to = 0;
  double least = 0.0;
  double stop_from = 0.0;  // where the policy acts it stops as an agent with this, see PolicyAgent

  template <class V>
  void Visit(V& v) {
    v.Required("from", from);
    v.Required("to", to);
    v("least", least);
    v("stop_from", stop_from);
  }
  void Validate() const {
    if (from < 0 || to < from) throw sim::KeyError("to", "to must not be before from");
    if (!(least >= 0.0 && least <= 1.0)) throw sim::KeyError("least", "least must be in [0, 1]");
    if (!(stop_from >= 0.0 && stop_from < 1.0)) {
      throw sim::KeyError("stop_from", "stop_from must be in [0, 1)");
    }
  }
  double ShareAt(int step) const {
    if (step < from) return 1.0;
    if (step >= to) return least;
    return 1.0 - (1.0 - least) * (step - from) / (to - from);
  }
};

struct ImitationConfig : TrainPlan {
  NavigationPlan navigation;
  int lanes = 32;
  int group = 4;     // lanes that are learned from together
  int rollout = 32;  // steps of each lane in a step of the training
  /// Metres of way left at which the teacher stops. Nearer ones are fewer lessons, and go on where
  /// a stop would be right already.
  double stop_distance = 0.5;
  double stop_weight = 1.0;  // of steps in which the teacher stops; they are rare
  /// Of steps in which the teacher goes forward. It turns until it looks along its path to within
  /// one turn, so that a policy that knows the way less exactly would turn to and fro.
  double forward_weight = 1.0;
  int epochs = 1;       // over the same steps
  int minibatches = 1;  // of an epoch, each of whole groups and with an update of its own
  double gradient_norm = 1.0;
  std::optional<DaggerSpec> dagger;  // absent: behavioural cloning, the teacher always acts

  template <class V>
  void Visit(V& v) {
    TrainPlan::Visit(v);
    navigation.Visit(v);
    v("lanes", lanes);
    v("group", group);
    v("rollout", rollout);
    v("stop_distance", stop_distance);
    v("stop_weight", stop_weight);
    v("forward_weight", forward_weight);
    v("epochs", epochs);
    v("minibatches", minibatches);
    v("gradient_norm", gradient_norm);
    v("dagger", dagger);
  }
  bool heeds_device() const { return false; }  // groups of lanes are on processors
  void Validate() const {
    TrainPlan::Validate();
    navigation.Validate();
    internal::RequireAtLeast(1, rollout, "rollout");
    internal::RequireAtLeast(1, lanes, "lanes");
    internal::RequireAtLeast(1, epochs, "epochs");
    RequireGroups(lanes, group, minibatches);
    if (!(stop_distance > 0.0 && stop_distance < navigation.task().success.distance)) {
      throw sim::KeyError("stop_distance",
                          "stop_distance must be positive and less than a success takes, 1 m");
    }
    if (!(stop_weight > 0.0)) throw sim::KeyError("stop_weight", "stop_weight must be positive");
    if (!(forward_weight > 0.0)) {
      throw sim::KeyError("forward_weight", "forward_weight must be positive");
    }
    if (!(gradient_norm > 0.0)) {
      throw sim::KeyError("gradient_norm", "gradient_norm must be positive");
    }
  }
};

/// Behavioural cloning of the shortest path, and DAgger: a policy learns to do what a teacher who
/// sees the truth does. Source: Neural Topological SLAM, section 5.1.
class ImitationTraining final : public LaneTraining {
 public:
  static constexpr std::string_view kName = "imitation";
  using Config = ImitationConfig;

  ImitationTraining(const Config& config, const TrainContext& context)
      : LaneTraining(config.navigation.GoingOn(),
                     {config.lanes, config.group, config.rollout, config.minibatches}, context),
        config_(config) {
    TakeNet([config] {
      return config.navigation.MakeNet(config.seed);
    });
    NavigationSpec spec = config.navigation.Lanes(Share());
    spec.teacher_stops = config.stop_distance;
    TakeLanes(spec, picture_net(), config.seed);
    if (config.dagger) picture_net()->StopFrom(config.dagger->stop_from);
  }

  double Learn(const TrainStep& step) override {
    PlaySpec play;
    play.steps = config_.rollout;
    play.lessons = true;
    play.taught_episodes = config_.dagger ? config_.dagger->ShareAt(step.step) : 1.0;
    play.values = false;
    lanes()->StartRollout(1.0 * step.step / config_.steps);
    const Rollout rollout = actor()->Play(play, {});
    const std::uint64_t seed = sim::MixSeed(config_.seed, static_cast<std::uint64_t>(step.step));
    const bool takes_memory = play.taught_episodes >= 1.0 && picture_net()->learns_to_see();
    Learned learned;
    for (int epoch = 0; epoch < config_.epochs; ++epoch) {
      sim::Rng rng = sim::Rng(seed, "lanes").Fork("epoch", static_cast<std::uint64_t>(epoch));
      learned = LearnOnce(rollout, &rng, step);
      if (takes_memory && epoch == 0) actor()->SetHidden(at::cat(learned.hidden));
    }
    agreement_ = learned.agreement;
    return learned.loss;
  }

  std::string title() const override { return "A policy that imitates the shortest path"; }

 private:
  /// What an epoch comes to: means over all groups.
  struct Learned {
    double loss = 0.0;
    double agreement = 0.0;
    std::vector<torch::Tensor> hidden;  // of own groups, at the rollout's end
  };

  void AppendLearned(Measures* measures) const override { (*measures)("agreement", agreement_); }

  /// Each of the rollout's groups once, with an update after each minibatch.
  Learned LearnOnce(const Rollout& rollout, sim::Rng* rng, const TrainStep& step) {
    const std::vector<int> own = groups()->Own(AllGroups());
    Learned learned;
    learned.hidden.resize(own.size());
    std::vector<double> agreed(own.size());
    for (const std::vector<int>& minibatch :
         DrawMinibatches(groups()->groups(), config_.minibatches, rng)) {
      const std::vector<double> losses =
          groups()->Differentiate(minibatch, [&](int group, ActorCritic* net) {
            const auto at = static_cast<std::size_t>(group - own.front());
            return Loss(rollout, groups()->LanesOf(group), net, &learned.hidden[at], &agreed[at]);
          });
      learned.loss += Mean(losses) / config_.minibatches;
      LimitGradients(net(), config_.gradient_norm);
      step.optimiser->Step(step.rate);
    }
    learned.agreement = Mean(groups()->Gather(agreed));
    return learned;
  }

  torch::Tensor Loss(const Rollout& rollout, const torch::Tensor& lanes, ActorCritic* net,
                     torch::Tensor* hidden, double* agreed) const {
    const auto of = [&](const torch::Tensor& all) {
      return all.index_select(1, lanes);
    };
    const ActorCritic::Output output = net->Run(rollout.SeenBy(net, lanes), of(rollout.starts),
                                                rollout.hidden.index_select(0, lanes));
    *hidden = output.hidden.detach();
    const ImitationLoss found = ImitationLossOf(output.log_probabilities, of(rollout.lessons),
                                                {config_.stop_weight, config_.forward_weight});
    *agreed = found.agreement;
    return found.loss;
  }

  Config config_;
  double agreement_ = 0.0;
};

const TrainerRegistration<ImitationTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
