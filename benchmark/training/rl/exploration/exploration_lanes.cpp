// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/exploration_lanes.h"

#include <fmt/core.h>

#include "agent/policy/exploration_view.h"
#include "benchmark/base/memory.h"
#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

constexpr int kMiddle = 4096;
constexpr int kSide = 8192;

}  // namespace

int ActionOf(const agent::GoalSteps& goal) {
  return (goal[0] + kMiddle) * kSide + goal[1] + kMiddle;
}

agent::GoalSteps GoalOf(int action) {
  return {action / kSide - kMiddle, action % kSide - kMiddle};
}

namespace {

/// Throws if the maps of so many bodies do not fit into memory.
std::size_t LanesThatFit(int lanes) {
  constexpr double kLaneBytes = 6e6;  // measured, in an office of 300 m2
  RequireMemory(lanes * kLaneBytes, fmt::format("exploring in {} lanes", lanes),
                "take fewer lanes");
  return static_cast<std::size_t>(lanes);
}

}  // namespace

ExplorationLanes::ExplorationLanes(int lanes, const MapSimulatorSpec& spec,
                                   const ExplorationScenes* scenes, sim::WorkerPool* pool)
    : spec_(spec), scenes_(scenes), pool_(pool), lanes_(LanesThatFit(lanes)) {
  for (Lane& lane : lanes_) lane.simulator = std::make_unique<MapSimulator>(spec);
}

std::size_t ExplorationLanes::picture_bytes() const {
  return agent::kExplorationBytes;
}

void ExplorationLanes::Begin(int lane, std::uint64_t episode) {
  Lane& own = lanes_[static_cast<std::size_t>(lane)];
  const ExplorationScenes::Drawn drawn = scenes_->Draw(lane, episode);
  own.simulator->Begin(*drawn.scene, drawn.start, drawn.seed);
  own.episode = episode;
  own.goals.clear();
}

void ExplorationLanes::Observe(std::span<float> numbers, std::span<std::uint8_t> pictures) {
  pool_->ForEach(lanes(), [&](int lane, int) {
    const auto i = static_cast<std::size_t>(lane);
    numbers[i] = static_cast<float>(lanes_[i].simulator->heading());
    lanes_[i].simulator->Show(pictures.subspan(i * picture_bytes(), picture_bytes()));
  });
}

LaneOutcome ExplorationLanes::Walk(Lane* lane, const agent::GoalSteps& goal) const {
  LaneOutcome outcome;
  outcome.reward = kRewardPerArea * lane->simulator->Walk(goal);
  lane->goals.push_back(goal);
  // As in the released code of ANS: all episodes have the same length, and nothing follows.
  outcome.terminated = lane->simulator->is_over();
  outcome.score = lane->simulator->explored();
  return outcome;
}

void ExplorationLanes::Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) {
  pool_->ForEach(lanes(), [&](int lane, int) {
    const auto i = static_cast<std::size_t>(lane);
    outcomes[i] = Walk(&lanes_[i], GoalOf(actions[i]));
  });
}

std::vector<float> ExplorationLanes::State() const {
  const auto most = static_cast<std::size_t>(spec_.decisions());
  std::vector<float> state;
  state.reserve(lanes_.size() * (2 * most + 2));
  for (const Lane& lane : lanes_) {
    state.push_back(static_cast<float>(lane.episode));
    state.push_back(static_cast<float>(lane.goals.size()));
    for (std::size_t i = 0; i < most; ++i) {
      const agent::GoalSteps goal = i < lane.goals.size() ? lane.goals[i] : agent::GoalSteps{};
      for (const int steps : goal) state.push_back(static_cast<float>(steps));
    }
  }
  return state;
}

void ExplorationLanes::SetState(std::span<const float> state) {
  const auto size = 2 * static_cast<std::size_t>(spec_.decisions()) + 2;
  BULLETNAV_CHECK_EQ(state.size(), lanes_.size() * size);
  pool_->ForEach(lanes(), [&](int lane, int) {
    const auto i = static_cast<std::size_t>(lane);
    const auto own = state.subspan(i * size, size);
    Begin(lane, static_cast<std::uint64_t>(own[0]));
    for (std::size_t k = 0; k < static_cast<std::size_t>(own[1]); ++k) {
      Walk(&lanes_[i], {static_cast<int>(own[2 + 2 * k]), static_cast<int>(own[3 + 2 * k])});
    }
  });
}

}  // namespace bulletnav::bench
