// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/map_simulator.h"

#include <gmock/gmock.h>

#include "agent/policy/exploration_view.h"
#include "benchmark/training/rl/exploration/exploration_lanes.h"
#include "benchmark/training/rl/exploration/exploration_validation.h"
#include "sim/base/error.h"
#include "tests/support/houses.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

class MapSimulatorTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new tests::TemporaryFolder();
    tests::WriteShellHouses(folder_->path(), 2, 1);
    scenes_ = new ExplorationScenes(
        {folder_->path() / "house_000.glb", folder_->path() / "house_001.glb"}, {}, 3, 1);
  }
  static void TearDownTestSuite() {
    delete scenes_;
    delete folder_;
  }
  static MapSimulatorSpec Spec() {
    MapSimulatorSpec spec;
    spec.episode_steps = 100;
    return spec;
  }

  static tests::TemporaryFolder* folder_;
  static ExplorationScenes* scenes_;
};

tests::TemporaryFolder* MapSimulatorTest::folder_ = nullptr;
ExplorationScenes* MapSimulatorTest::scenes_ = nullptr;

TEST_F(MapSimulatorTest, WalksToGoalsAndSeesMore) {
  MapSimulator simulator(Spec());
  const ExplorationScenes::Drawn drawn = scenes_->Draw(0, 0);
  simulator.Begin(*drawn.scene, drawn.start, drawn.seed);
  const double at_first = simulator.explored();
  EXPECT_GT(at_first, 3.0);
  double reward = 0.0;
  double moved = 0.0;
  for (int i = 0; i < 4; ++i) {
    const sim::BodyPose before = simulator.true_pose();
    reward += simulator.Walk({500, i % 2 == 0 ? 300 : -300});
    moved += (simulator.true_pose().position - before.position).norm();
  }
  EXPECT_TRUE(simulator.is_over());
  EXPECT_GT(moved, 1.0);
  EXPECT_GT(reward, 0.5);
  EXPECT_NEAR(at_first + reward, simulator.explored(), 1e-9);
  EXPECT_LT(simulator.collisions(), 25);
  // What it believes is near the truth.
  const sim::PlanarPose truth = sim::RelativePose(drawn.start, simulator.true_pose());
  const sim::PlanarPose believed = simulator.navigator().pose();
  EXPECT_LT(std::hypot(truth.x - believed.x, truth.y - believed.y), 0.5);
}

TEST_F(MapSimulatorTest, FloorFarFromTheStartIsWorthLess) {
  const ExplorationScenes::Drawn drawn = scenes_->Draw(0, 0);
  const auto walk = [&](std::optional<double> near_start) {
    MapSimulatorSpec spec = Spec();
    spec.near_start = near_start;
    auto simulator = std::make_unique<MapSimulator>(spec);
    simulator->Begin(*drawn.scene, drawn.start, drawn.seed);
    for (int i = 0; i < 4; ++i) simulator->Walk({500, i % 2 == 0 ? 300 : -300});
    return simulator;
  };
  const auto alike = walk(std::nullopt);
  EXPECT_DOUBLE_EQ(alike->worth(), alike->explored());
  const auto all_is_near = walk(100.0);
  EXPECT_NEAR(all_is_near->worth(), alike->explored(), 1e-6);
  const auto near = walk(2.0);
  EXPECT_DOUBLE_EQ(near->explored(), alike->explored());
  EXPECT_LT(near->worth(), 0.95 * near->explored());
  EXPECT_GT(near->worth(), 0.3 * near->explored());
}

TEST_F(MapSimulatorTest, IsAFunctionOfStartSeedAndGoals) {
  std::vector<std::vector<std::uint8_t>> views;
  MapSimulator used(Spec());
  const ExplorationScenes::Drawn other = scenes_->Draw(1, 5);
  used.Begin(*other.scene, other.start, 1);
  used.Walk({0, 900});
  MapSimulator fresh(Spec());
  for (MapSimulator* simulator : {&used, &fresh}) {
    const ExplorationScenes::Drawn drawn = scenes_->Draw(0, 2);
    simulator->Begin(*drawn.scene, drawn.start, drawn.seed);
    simulator->Walk({-300, 200});
    simulator->Walk({400, 0});
    simulator->Show(views.emplace_back(agent::kExplorationBytes));
  }
  EXPECT_EQ(views[0], views[1]);
}

struct Shown {
  std::vector<float> numbers;
  std::vector<std::uint8_t> views;
  bool operator==(const Shown&) const = default;
};

Shown Look(ExplorationLanes* lanes) {
  const auto count = static_cast<std::size_t>(lanes->lanes());
  Shown shown{std::vector<float>(count), std::vector<std::uint8_t>(count * lanes->picture_bytes())};
  lanes->Observe(shown.numbers, shown.views);
  return shown;
}

TEST_F(MapSimulatorTest, LanesGoOnFromTheirStateOnAnyNumberOfThreads) {
  const std::vector<int> actions = {ActionOf({100, 0}), ActionOf({-400, 250}), ActionOf({0, 0})};
  const auto step = [&](ExplorationLanes* lanes) {
    std::vector<LaneOutcome> outcomes(3);
    lanes->Step(actions, outcomes);
    return outcomes;
  };
  sim::WorkerPool two(2);
  ExplorationLanes lanes(3, Spec(), scenes_, &two);
  for (int lane = 0; lane < 3; ++lane) lanes.Begin(lane, static_cast<std::uint64_t>(lane));
  step(&lanes);
  const std::vector<float> state = lanes.State();
  const auto expected = step(&lanes);
  const Shown shown = Look(&lanes);
  sim::WorkerPool one(1);
  ExplorationLanes again(3, Spec(), scenes_, &one);
  again.SetState(state);
  EXPECT_EQ(again.State(), state);
  const auto outcomes = step(&again);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(outcomes[i].reward, expected[i].reward);
    EXPECT_EQ(outcomes[i].score, expected[i].score);
    EXPECT_FALSE(outcomes[i].is_over());
  }
  EXPECT_EQ(Look(&again), shown);
  step(&again);
  EXPECT_TRUE(step(&again)[0].terminated);
}

TEST_F(MapSimulatorTest, GoalsAreWholeNumbersAndBack) {
  for (const agent::GoalSteps& goal :
       {agent::GoalSteps{0, 0}, agent::GoalSteps{-4095, 4095}, agent::GoalSteps{17, -900}}) {
    EXPECT_EQ(GoalOf(ActionOf(goal)), goal);
  }
}

TEST_F(MapSimulatorTest, ValidationIsTheSameForAnyNumberOfThreads) {
  const ExplorationValidation validation(scenes_, Spec(), 3);
  sim::WorkerPool one(1);
  sim::WorkerPool two(2);
  const ExplorationValidation::Result result = validation.MeasureRandomGoals(&one);
  EXPECT_GT(result.explored, 5.0);
  EXPECT_GT(validation.MeasureFrontiers(&two).explored, 5.0);
  EXPECT_EQ(validation.MeasureRandomGoals(&two).explored, result.explored);
}

TEST(MapSimulatorSpec, RefusesANearnessOfNothing) {
  MapSimulatorSpec spec;
  spec.near_start = 0.0;
  EXPECT_THROW(spec.Validate(), sim::Error);
}

TEST(MapSimulatorSpec, RefusesEpisodesThatGoalsDoNotFill) {
  MapSimulatorSpec spec;
  spec.episode_steps = 90;
  EXPECT_THROW(spec.Validate(), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
