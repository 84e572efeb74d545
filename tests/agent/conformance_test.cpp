// SPDX-License-Identifier: MIT
// What every registered agent must keep to, whatever it does.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "agent/models/goal_estimator.h"
#include "agent/models/usual_slots.h"
#include "agent/policy/exploration_policy.h"
#include "agent/policy/policy_model.h"
#include "agent/registry.h"
#include "sim/base/error.h"
#include "sim/simulator.h"
#include "tests/support/scenes.h"

namespace bulletnav::agent {
namespace {

using Actions = std::vector<sim::Action>;

/// Answers from the brightness of a panorama's corner, whatever it shows; the goal is always, or
/// never, in one place.
class FixedModel final : public SemanticModel, public GoalEstimator {
 public:
  explicit FixedModel(bool sees) : sees_(sees) {}

  std::optional<RelativeGoal> Estimate(const Panorama& /*here*/,
                                       const Panorama& /*goal*/) override {
    if (!sees_) return std::nullopt;
    return RelativeGoal{2.0, 1.5};
  }

  std::vector<PanoramaCode> Encode(std::span<const Panorama> panoramas) override {
    std::vector<PanoramaCode> codes;
    for (const Panorama& panorama : panoramas) {
      codes.push_back({static_cast<float>(panorama.color.front()) / 255.0f});
    }
    return codes;
  }

  std::array<float, kDirections> Explorable(const PanoramaCode& source) override {
    std::array<float, kDirections> open = {};
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = Mixed(source[0], i);
    return open;
  }

  std::vector<PairPrediction> Compare(std::span<const PanoramaCode* const> sources,
                                      const PanoramaCode& goal) override {
    std::vector<PairPrediction> predictions;
    for (const PanoramaCode* source : sources) {
      PairPrediction& p = predictions.emplace_back();
      p.same_node = sees_ ? 0.9f : 0.6f * Mixed((*source)[0] + goal[0], 12);
      p.distance = 3.0f * Mixed((*source)[0] - goal[0], 13);
      p.direction[3] = 1.0f;
      for (std::size_t i = 0; i < p.score.size(); ++i) p.score[i] = Mixed((*source)[0], 14 + i);
    }
    return predictions;
  }

 private:
  /// Some number from 0 to 1.
  static float Mixed(float value, std::size_t salt) {
    const float x = 7.3f * value + 0.37f * static_cast<float>(salt);
    return x - std::floor(x);
  }

  bool sees_;
};

/// Sees half the cells, an obstacle in some, by the brightness of a panorama's corner.
class FixedMapper final : public FreeSpaceModel {
 public:
  FreeSpace Predict(const Panorama& panorama) override {
    FreeSpace space;
    const int light = panorama.color.front();
    for (int i = 0; i < FreeSpace::kSide * FreeSpace::kSide; ++i) {
      const auto cell = static_cast<std::size_t>(i);
      space.explored[cell] = (i / 40 + light) % 2 == 0 ? 0.9f : 0.1f;
      space.obstacle[cell] = (i + 13 * light) % 31 == 0 ? 0.8f : 0.2f;
    }
    return space;
  }
};

/// Turns to one side or goes ahead by the brightness of a panorama's corner, and remembers steps;
/// every so often it would rather stop.
class FixedPolicy final : public PolicyModel {
 public:
  explicit FixedPolicy(bool sees_map) : sees_map_(sees_map) {}

  bool sees_map() const override { return sees_map_; }
  int step_limit() const override { return 500; }
  std::vector<float> NoMemory() const override { return {0.0f}; }
  std::vector<float> CodeOf(const Panorama& goal) override {
    return {static_cast<float>(goal.color.front()) / 255.0f};
  }
  std::array<float, 4> Act(const PolicyQuestion& question, std::vector<float>* memory) override {
    memory->front() += 1.0f;
    const float light = static_cast<float>(question.panorama.color.front()) / 255.0f;
    float left = 0.5f * std::fabs(light - question.goal.front());
    if (!question.map.empty()) left = static_cast<float>(question.map[1536] % 8) / 16.0f;
    return {memory->front() > 30.0f ? 0.4f : 0.0f, 0.5f, left, 0.5f - left};
  }

 private:
  bool sees_map_;
};

/// Goals to one side or another by how much is mapped.
class FixedExploration final : public ExplorationPolicy {
 public:
  GoalDistribution Ask(std::span<const std::uint8_t> view, int heading) override {
    const auto known = std::count_if(view.begin(), view.end(), [](std::uint8_t pixel) {
      return pixel != 0;
    });
    return {{0.01 * static_cast<double>(known % 200) - 1.0, 0.02 * heading - 0.7}, {0.5, 0.5}};
  }
};

sim::SimulatorSpec SmallSpec() {
  sim::SimulatorSpec spec;
  spec.panorama.rows = 16;
  spec.panorama.cols = 64;
  return spec;
}

AgentContext Context(bool sees = false) {
  AgentContext context;
  context.rig.panorama = SmallSpec().panorama;
  context.models.Set("semantic_model", std::make_shared<FixedModel>(sees));
  context.models.Set("policy", std::make_shared<FixedPolicy>(false));
  context.models.Set("exploration", std::make_shared<FixedExploration>());
  return context;
}

AgentContext ColorContext() {
  AgentContext context = Context();
  context.rig.has_depth = false;
  context.models.Set("mapper", std::make_shared<FixedMapper>());
  return context;
}

/// What a body sees on a random noisy walk against furniture and walls.
std::vector<sim::Observation> RandomWalk(std::uint64_t seed, int steps) {
  sim::SceneMesh room = tests::BoxRoom(4, 2.6f, 6);
  tests::AddBox({1.0f, 0, -4}, {1.8f, 0.9f, -3}, {9, 9, 9}, &room);
  sim::Simulator simulator(sim::World::FromMesh(room, "room"), SmallSpec());
  sim::Rng rng(seed, "walk");
  std::vector<sim::Observation> seen = {simulator.Reset({{2, 0, -1}, 0.0}, {seed, 0})};
  for (int i = 1; i < steps; ++i) {
    const bool ahead = rng.Chance(0.6);
    const bool left = rng.Chance(0.5);
    seen.push_back(simulator.Step(ahead  ? sim::Action::kMoveForward
                                  : left ? sim::Action::kTurnLeft
                                         : sim::Action::kTurnRight));
  }
  return seen;
}

std::unique_ptr<BatchAgent> Make(const std::string& name, std::span<const AgentContext> contexts) {
  std::vector<AgentContext> own(contexts.begin(), contexts.end());
  for (AgentContext& context : own) {
    const bool has_policy = context.models.Find<PolicyModel>("policy") != nullptr;
    if (has_policy) {
      context.models.Set("policy", std::make_shared<FixedPolicy>(name == "metric_map_rl"));
    }
  }
  return ConfigureAgent(name)(own);
}

std::unique_ptr<BatchAgent> MakeOne(const std::string& name, bool sees = false) {
  return Make(name, std::array{Context(sees)});
}

/// The actions of lane 0 from Reset on. Goes on after a stop: what an agent then does is moot, but
/// it must not break.
Actions ActAll(BatchAgent* agent, const std::vector<sim::Observation>& seen, std::uint64_t seed) {
  const sim::Observation& goal = seen.back();
  agent->Reset(0, View(goal, 0).panorama, seed);
  Actions actions;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    std::array action = {sim::Action::kStop};
    agent->Act(std::array{LaneObservation{0, View(seen[i], static_cast<int>(i))}}, action);
    actions.push_back(action[0]);
  }
  return actions;
}

void ExpectLegal(const Actions& actions) {
  for (const sim::Action action : actions) {
    EXPECT_NE(std::find(sim::kAllActions.begin(), sim::kAllActions.end(), action),
              sim::kAllActions.end());
  }
}

class Conformance : public testing::TestWithParam<std::string> {};

TEST_P(Conformance, TheSameSeedAndObservationsGiveTheSameLegalActions) {
  const auto seen = RandomWalk(1, 60);
  for (const bool sees : {false, true}) {
    const Actions first = ActAll(MakeOne(GetParam(), sees).get(), seen, 7);
    ExpectLegal(first);
    EXPECT_EQ(first, ActAll(MakeOne(GetParam(), sees).get(), seen, 7));
  }
}

TEST_P(Conformance, WorksFromColorAloneWithAMapper) {
  auto seen = RandomWalk(1, 40);
  for (sim::Observation& observation : seen) observation.depth.clear();
  const auto act = [&] {
    return ActAll(Make(GetParam(), std::array{ColorContext()}).get(), seen, 7);
  };
  try {
    Make(GetParam(), std::array{ColorContext()});
  } catch (const sim::Error& e) {
    ASSERT_THAT(e.what(), testing::HasSubstr("depth"));
    GTEST_SKIP() << "needs more than colour: " << e.what();
  }
  const Actions first = act();
  ExpectLegal(first);
  EXPECT_EQ(first, act());
}

TEST_P(Conformance, NothingOutlivesAReset) {
  const auto before = RandomWalk(1, 60);
  const auto after = RandomWalk(2, 60);
  const auto used = MakeOne(GetParam());
  ActAll(used.get(), before, 7);
  EXPECT_EQ(ActAll(used.get(), after, 8), ActAll(MakeOne(GetParam()).get(), after, 8));
}

TEST_P(Conformance, LanesDoNotKnowOfEachOther) {
  const auto mine = RandomWalk(1, 30);
  const auto other = RandomWalk(2, 30);
  const std::array contexts = {Context(), Context(), Context()};
  const auto agent = Make(GetParam(), contexts);
  ASSERT_EQ(agent->lanes(), 3);
  agent->Reset(1, View(other.back(), 0).panorama, 3);
  agent->Reset(2, View(mine.back(), 0).panorama, 7);
  Actions actions;
  for (int i = 0; i < 30; ++i) {
    const auto n = static_cast<std::size_t>(i);
    std::array two = {sim::Action::kStop, sim::Action::kStop};
    if (i % 3 == 0) {  // lane 1 is not always there
      agent->Act(std::array{LaneObservation{2, View(mine[n], i)}}, std::span(two).first(1));
      actions.push_back(two[0]);
    } else {
      agent->Act(
          std::array{LaneObservation{1, View(other[n], i)}, LaneObservation{2, View(mine[n], i)}},
          two);
      actions.push_back(two[1]);
    }
  }
  EXPECT_EQ(actions, ActAll(MakeOne(GetParam()).get(), mine, 7));
}

TEST_P(Conformance, SurvivesBlankCollidedAndBrokenObservations) {
  auto seen = RandomWalk(1, 40);
  for (std::size_t i = 10; i < 30; ++i) {
    std::fill(seen[i].color.begin(), seen[i].color.end(), std::uint8_t{0});
    const float broken = i < 17 ? 0.0f : i < 24 ? std::nanf("") : 1e30f;
    std::fill(seen[i].depth.begin(), seen[i].depth.end(), broken);
    seen[i].sensors.collided = true;
    seen[i].sensors.odometry = {};
  }
  for (const bool sees : {false, true}) {
    ExpectLegal(ActAll(MakeOne(GetParam(), sees).get(), seen, 7));
  }
}

TEST_P(Conformance, TakesANextGoalInTheSameEpisode) {
  const auto seen = RandomWalk(1, 20);
  const auto agent = MakeOne(GetParam());
  ActAll(agent.get(), seen, 7);
  agent->NextGoal(0, View(seen.front(), 0).panorama, 9);
  std::array action = {sim::Action::kStop};
  agent->Act(std::array{LaneObservation{0, View(seen[1], 20)}}, action);
  ExpectLegal({action[0]});
}

std::vector<ModelSlot> NeededSlots(const std::string& name, const Rig& rig) {
  std::vector<ModelSlot> slots = ModelSlotsOf(name, rig);
  std::erase_if(slots, [](const ModelSlot& slot) {
    return !slot.is_needed;
  });
  return slots;
}

TEST_P(Conformance, ModelsThatItNeedsAreNamedWhereTheyAreMissing) {
  AgentContext bare;
  bare.rig.panorama = SmallSpec().panorama;
  const std::vector<ModelSlot> needed = NeededSlots(GetParam(), bare.rig);
  try {
    EXPECT_EQ(Make(GetParam(), std::array{bare})->lanes(), 1);
    EXPECT_TRUE(needed.empty()) << "does without '" << needed.front().name << "'";
  } catch (const sim::Error& e) {
    ASSERT_FALSE(needed.empty()) << e.what();
    EXPECT_THAT(e.what(), testing::HasSubstr("models: {" + needed.front().name));
  }
}

TEST_P(Conformance, TakesTheModelsThatItsSlotsAccept) {
  for (const AgentContext& context : {Context(), ColorContext()}) {
    for (const ModelSlot& slot : NeededSlots(GetParam(), context.rig)) {
      const auto model = context.models.Find<Model>(slot.name);
      ASSERT_NE(model, nullptr) << slot.name;
      EXPECT_TRUE(slot.accepts(*model));
      EXPECT_FALSE(slot.accepts(Model()));
      EXPECT_FALSE(slot.interface.empty());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Agents, Conformance, testing::ValuesIn(AgentNames()),
                         [](const auto& agent) {
                           return agent.param;
                         });

}  // namespace
}  // namespace bulletnav::agent
