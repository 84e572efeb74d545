// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/number_net.h"
#include "benchmark/training/rl/ppo_training.h"
#include "benchmark/training/rl/sanity/number_task.h"

namespace bulletnav::bench {
namespace {

constexpr int kValidationLanes = 1024;
constexpr int kNumbers = 4;  // cue left, cue right, the end is here, always 1

struct CorridorSpec {
  int shortest = 2;  // steps of the corridor in training, drawn evenly up to
  int length = 60;   // this, which it always is in validation

  template <class V>
  void Visit(V& v) {
    v("shortest", shortest);
    v("length", length);
  }
  void Validate() const {
    if (shortest < 1) throw sim::KeyError("shortest", "shortest must be at least 1");
    if (length < shortest) throw sim::KeyError("length", "length must not be below shortest");
  }
};

struct CorridorLane {
  int cue = 0;
  int length = 0;
  int steps = 0;

  std::array<int*, 3> Numbers() { return {&cue, &length, &steps}; }
};

/// A corridor that ends in a fork: a cue in its first step says which way is right, and nothing in
/// the others. Rollouts are shorter than the corridor, so that memory must live through updates;
/// short corridors teach what long ones need. Source of the task: Hochreiter and Schmidhuber,
/// "Long short-term memory", 1997, as a corridor in Bakker, "Reinforcement learning with long
/// short-term memory", 2002.
class Corridor final : public NumberTask<CorridorLane> {
 public:
  Corridor(const CorridorSpec& spec, const LaneShare& share, std::uint64_t seed)
      : NumberTask("corridor", share, seed), spec_(spec) {}

  int actions() const override { return 2; }
  int observation_size() const override { return kNumbers; }

  void Begin(int lane, std::uint64_t episode) override {
    sim::Rng rng = RngOf(lane, episode);
    this->lane(lane) = {rng.Below(2), spec_.shortest + rng.Below(spec_.length - spec_.shortest + 1),
                        0};
  }
  void Observe(std::span<float> out, std::span<std::uint8_t> /*pictures*/) override {
    std::fill(out.begin(), out.end(), 0.0F);
    float* numbers = out.data();
    for (const CorridorLane& lane : all_lanes()) {
      if (lane.steps == 0) numbers[lane.cue] = 1.0F;
      numbers[2] = lane.steps == lane.length ? 1.0F : 0.0F;
      numbers[3] = 1.0F;
      numbers += kNumbers;
    }
  }
  void Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) override {
    for (std::size_t i = 0; i < actions.size(); ++i) {
      CorridorLane& lane = all_lanes()[i];
      LaneOutcome outcome;
      outcome.terminated = lane.steps == lane.length;
      outcome.success = outcome.terminated && actions[i] == lane.cue;
      outcome.score = outcome.success ? 1.0 : 0.0;
      if (outcome.terminated) outcome.reward = outcome.success ? 1.0 : -1.0;
      outcomes[i] = outcome;
      if (!outcome.terminated) ++lane.steps;
    }
  }

 private:
  CorridorSpec spec_;
};

struct MemoryConfig : PpoPlan {
  NumberNetSpec model;
  CorridorSpec corridor;

  template <class V>
  void Visit(V& v) {
    PpoPlan::Visit(v);
    v("model", model);
    v("corridor", corridor);
  }
  void Validate() const { PpoPlan::Validate(); }
};

class MemoryTraining final : public PpoTraining {
 public:
  static constexpr std::string_view kName = "memory";
  using Config = MemoryConfig;
  MemoryTraining(const Config& config, const TrainContext& context)
      : PpoTraining(
            config,
            [config] {
              return std::make_unique<NumberNet>(config.model, kNumbers, 2, config.seed);
            },
            [config, context](sim::WorkerPool*) {
              return std::make_unique<Corridor>(
                  config.corridor, Share(config.ppo, context.peers.get()), config.seed);
            },
            context.peers),
        config_(config) {}

  std::string title() const override { return "A cue to remember"; }

  /// "success" is of one episode a lane, acted as in training, all of the longest corridor.
  Measures Validate() override {
    CorridorSpec longest = config_.corridor;
    longest.shortest = longest.length;
    Corridor task(longest, {kValidationLanes, 0}, config_.seed + 1);
    Actor actor(&task, &policy(), pool(), config_.ppo.group, config_.seed + 1);
    PlaySpec play;
    play.steps = longest.length + 1;
    double sum = 0.0;
    for (const EndedEpisode& ended : actor.Play(play, moments()).ended) sum += ended.score;
    const double success = sum / kValidationLanes;
    Measures measures;
    measures("loss", 1.0 - success);
    measures("success", success);
    AppendReport(&measures);
    return measures;
  }
  std::string Describe(const Measures& measures) const override {
    return fmt::format("success {:.3f}, entropy {:.2f}, KL {:.4f}", measures.at("success"),
                       measures.at("entropy"), measures.at("kl"));
  }
  std::vector<CurveLine> curves() const override { return {{"success", "success"}}; }
  std::string validated_on() const override { return "corridors of full length"; }

 private:
  Config config_;
};

const TrainerRegistration<MemoryTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
