// SPDX-License-Identifier: MIT
#include <array>
#include <cstdlib>
#include <memory>
#include <queue>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/number_net.h"
#include "benchmark/training/rl/ppo_training.h"
#include "benchmark/training/rl/sanity/number_task.h"

namespace bulletnav::bench {
namespace {

constexpr int kSide = 11;
constexpr int kCells = kSide * kSide;
constexpr int kLimit = 200;  // steps; longer episodes are cut
constexpr int kValidationLanes = 256;
constexpr double kStepCost = 0.01;
constexpr int kGoal = 8 * kSide + 8;
constexpr std::array kRooms = {std::string_view(".....#....."), std::string_view(".....#....."),
                               std::string_view("..........."), std::string_view(".....#....."),
                               std::string_view(".....#....."), std::string_view("#.####....."),
                               std::string_view(".....###.##"), std::string_view(".....#....."),
                               std::string_view(".....#....."), std::string_view("..........."),
                               std::string_view(".....#.....")};

bool IsFree(int cell) {
  return kRooms[static_cast<std::size_t>(cell / kSide)][static_cast<std::size_t>(cell % kSide)] ==
         '.';
}

/// Where an action leads: up, down, left, right; walls hold.
int Next(int cell, int action) {
  const int row = cell / kSide + (action == 1) - (action == 0);
  const int column = cell % kSide + (action == 3) - (action == 2);
  if (row < 0 || row >= kSide || column < 0 || column >= kSide) return cell;
  const int next = row * kSide + column;
  return IsFree(next) ? next : cell;
}

/// Steps to the goal, from each cell.
std::array<int, kCells> Distances() {
  std::array<int, kCells> distances;
  distances.fill(-1);
  distances[kGoal] = 0;
  std::queue<int> open({kGoal});
  for (; !open.empty(); open.pop()) {
    const int cell = open.front();
    for (int action = 0; action < 4; ++action) {
      int& distance = distances[static_cast<std::size_t>(Next(cell, action))];
      if (distance >= 0) continue;
      distance = distances[static_cast<std::size_t>(cell)] + 1;
      open.push(Next(cell, action));
    }
  }
  return distances;
}

struct FourRoomsLane {
  int start = 0;
  int cell = 0;
  int steps = 0;

  std::array<int*, 3> Numbers() { return {&start, &cell, &steps}; }
};

/// Four rooms, seen from above: from anywhere to the one goal. Source of the rooms: Sutton, Precup
/// and Singh, "Between MDPs and semi-MDPs", 1999. An episode's score: its return, by the best one.
class FourRooms final : public NumberTask<FourRoomsLane> {
 public:
  FourRooms(const LaneShare& share, std::uint64_t seed) : NumberTask("four_rooms", share, seed) {}

  int actions() const override { return 4; }
  int observation_size() const override { return kCells; }

  void Begin(int lane, std::uint64_t episode) override {
    sim::Rng rng = RngOf(lane, episode);
    int cell = kGoal;
    while (cell == kGoal || !IsFree(cell)) cell = rng.Below(kCells);
    this->lane(lane) = {cell, cell, 0};
  }
  void Observe(std::span<float> out, std::span<std::uint8_t> /*pictures*/) override {
    std::fill(out.begin(), out.end(), 0.0F);
    std::size_t first = 0;
    for (const FourRoomsLane& lane : all_lanes()) {
      out[first + static_cast<std::size_t>(lane.cell)] = 1.0F;
      first += kCells;
    }
  }
  void Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) override {
    for (std::size_t i = 0; i < actions.size(); ++i) {
      outcomes[i] = Move(&all_lanes()[i], actions[i]);
    }
  }

 private:
  LaneOutcome Move(FourRoomsLane* lane, int action) const {
    lane->cell = Next(lane->cell, action);
    ++lane->steps;
    LaneOutcome outcome;
    outcome.terminated = lane->cell == kGoal;
    outcome.truncated = !outcome.terminated && lane->steps >= kLimit;
    outcome.reward = (outcome.terminated ? 1.0 : 0.0) - kStepCost;
    const double best = 1.0 - kStepCost * distances_[static_cast<std::size_t>(lane->start)];
    const double reached = outcome.terminated ? 1.0 : 0.0;
    outcome.success = outcome.terminated;
    outcome.score = (reached - kStepCost * lane->steps) / best;
    return outcome;
  }

  std::array<int, kCells> distances_ = Distances();
};

struct FourRoomsConfig : PpoPlan {
  NumberNetSpec model;
  int validation_steps = 200;  // that an episode of a validation may take

  template <class V>
  void Visit(V& v) {
    PpoPlan::Visit(v);
    v("model", model);
    v("validation_steps", validation_steps);
  }
  void Validate() const {
    PpoPlan::Validate();
    internal::RequireAtLeast(1, validation_steps, "validation_steps");
  }
};

class FourRoomsTraining final : public PpoTraining {
 public:
  static constexpr std::string_view kName = "four_rooms";
  using Config = FourRoomsConfig;
  FourRoomsTraining(const Config& config, const TrainContext& context)
      : PpoTraining(
            config,
            [config] {
              return std::make_unique<NumberNet>(config.model, kCells, 4, config.seed);
            },
            [config, context](sim::WorkerPool*) {
              return std::make_unique<FourRooms>(Share(config.ppo, context.peers.get()),
                                                 config.seed);
            },
            context.peers),
        config_(config) {}

  std::string title() const override { return "Four rooms"; }

  /// "score" is the mean of the lanes' first episodes, acted as in training; one that does not end
  /// in time scores nothing. "loss" is what the score lacks of 1.
  Measures Validate() override {
    FourRooms task({kValidationLanes, 0}, config_.seed + 1);
    Actor actor(&task, &policy(), pool(), config_.ppo.group, config_.seed + 1);
    PlaySpec play;
    play.steps = config_.validation_steps;
    double sum = 0.0;
    double episodes = 0.0;
    for (const EndedEpisode& ended : actor.Play(play, moments()).ended) {
      if (ended.episode > 0) continue;
      sum += ended.score;
      episodes += 1.0;
    }
    const double score = sum / kValidationLanes;
    Measures measures;
    measures("loss", 1.0 - score);
    measures("score", score);
    measures("episodes", episodes);
    AppendReport(&measures);
    return measures;
  }
  std::string Describe(const Measures& measures) const override {
    return fmt::format("score {:.3f} of {:.0f} episodes, entropy {:.2f}, KL {:.4f}",
                       measures.at("score"), measures.at("episodes"), measures.at("entropy"),
                       measures.at("kl"));
  }
  std::vector<CurveLine> curves() const override { return {{"score", "score"}}; }
  std::string validated_on() const override { return "episodes that no training has played"; }

 private:
  Config config_;
};

const TrainerRegistration<FourRoomsTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
