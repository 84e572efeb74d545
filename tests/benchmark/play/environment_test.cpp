// SPDX-License-Identifier: MIT
#include "benchmark/play/environment.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "sim/simulator.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

using sim::Action;
using testing::HasSubstr;

std::shared_ptr<const sim::World> Room(const std::string& name = "room") {
  sim::SceneMesh room = tests::BoxRoom(8, 2.6f, 8);
  tests::AddBox({3.5f, 0, -4.5f}, {4.5f, 0.9f, -3.5f}, {90, 20, 20}, &room);
  return sim::World::FromMesh(room, name);
}

Task SmallTask() {
  Task task;
  task.panorama.rows = 16;
  task.panorama.cols = 64;
  task.max_steps = 40;
  return task;
}

/// From (1, -1), looking along -z, to goals at z = -1 - metres, one after the other.
EpisodeTask Ahead(const std::vector<double>& metres, const std::string& id = "e") {
  EpisodeTask task;
  task.key = {"agent", "rgbd", "noise", 1, "room", id};
  task.episode.id = id;
  task.episode.scene = "room";
  task.episode.start_position = {1, 0, -1};
  for (const double distance : metres) {
    EpisodeGoal& goal = task.episode.goals.emplace_back();
    goal.position = {1, 0, -1 - distance};
    goal.rotation = Rotation::FromYaw(0.0);
  }
  return task;
}

/// Lanes with truths of their own.
struct Lanes {
  explicit Lanes(const Task& task, int count = 1, int threads = 1)
      : truths(static_cast<std::size_t>(count)), environment(task, Pointers(), threads) {}
  std::vector<GroundTruth*> Pointers() {
    std::vector<GroundTruth*> pointers;
    for (GroundTruth& truth : truths) pointers.push_back(&truth);
    return pointers;
  }
  StepOutcome Step(Action action, int lane = 0) {
    return environment.Step({&lane, 1}, {&action, 1}).front();
  }

  std::vector<GroundTruth> truths;
  Environment environment;
};

TEST(Environment, ASuccessIsAStopNearTheGoal) {
  Lanes lanes(SmallTask());
  lanes.environment.Reset(0, Ahead({1.5}), Room());
  for (int i = 0; i < 6; ++i) {
    const StepOutcome outcome = lanes.Step(Action::kMoveForward);
    EXPECT_FALSE(outcome.terminated || outcome.truncated);
    EXPECT_EQ(outcome.reward, 0.0);
  }
  EXPECT_NEAR(lanes.truths[0].pose.position.z(), -2.5, 1e-3);
  EXPECT_TRUE(lanes.Step(Action::kStop).terminated);
  ASSERT_TRUE(lanes.environment.is_over(0));
  const EpisodeTrajectory trajectory = lanes.environment.Finish(0, {});
  EXPECT_TRUE(trajectory.result.goals[0].success());
  EXPECT_NEAR(trajectory.result.goals[0].Value("spl"), 1.0, 1e-3);
  EXPECT_EQ(trajectory.steps.size(), 7u);
  EXPECT_EQ(trajectory.result.failure, "");
}

TEST(Environment, StepsRunOutWithoutAStop) {
  Lanes lanes(SmallTask());
  lanes.environment.Reset(0, Ahead({1.5}), Room());
  for (int i = 0; i < 39; ++i) EXPECT_FALSE(lanes.Step(Action::kTurnLeft).truncated);
  const StepOutcome last = lanes.Step(Action::kTurnLeft);
  EXPECT_TRUE(last.truncated);
  EXPECT_FALSE(last.terminated);
  EXPECT_TRUE(lanes.environment.is_over(0));
  EXPECT_FALSE(lanes.environment.Finish(0, {}).result.goals[0].success());
}

TEST(Environment, WithoutStopBeingNearIsEnough) {
  Task task = SmallTask();
  task.success.no_stop = true;
  Lanes lanes(task);
  lanes.environment.Reset(0, Ahead({1.5}), Room());
  EXPECT_FALSE(lanes.Step(Action::kStop).terminated);  // does nothing
  EXPECT_FALSE(lanes.Step(Action::kMoveForward).terminated);
  EXPECT_FALSE(lanes.Step(Action::kMoveForward).terminated);
  EXPECT_TRUE(lanes.Step(Action::kMoveForward).terminated);  // 0.75 m are left
  EXPECT_TRUE(lanes.environment.Finish(0, {}).result.goals[0].success());
}

TEST(Environment, RewardsAddUpToProgressAndSuccess) {
  Task task = SmallTask();
  task.reward = RewardSpec{10.0, 2.0, -0.5};
  Lanes lanes(task);
  lanes.environment.Reset(0, Ahead({1.5}), Room());
  double sum = 0.0;
  for (int i = 0; i < 5; ++i) {
    const double reward = lanes.Step(Action::kMoveForward).reward;
    EXPECT_NEAR(reward, 2.0 * 0.25 - 0.5, 0.05);
    sum += reward;
  }
  sum += lanes.Step(Action::kStop).reward;
  const GoalMetrics goal = lanes.environment.Finish(0, {}).result.goals[0];
  EXPECT_TRUE(goal.success());
  const double gained = goal.Value("start_distance") - goal.Value("distance_to_goal");
  EXPECT_NEAR(sum, 2.0 * gained - 0.5 * 6 + 10.0 * goal.Value("spl"), 1e-9);
}

TEST(Environment, RewardsStayNumbersWhereNoWayLeadsToTheGoal) {
  Task task = SmallTask();
  task.reward = RewardSpec{10.0, 1.0, 0.0};
  TaskEpisode episode(Ahead({3.0}), task, Room());
  episode.StartGoal({{1, 0, -1}, 0.0});
  const auto reward = [&](double z) {
    return episode.Take(Action::kMoveForward, {{1, 0, z}, 0.0}, {}).reward;
  };
  EXPECT_NEAR(reward(-1.5), 0.5, 0.05);
  EXPECT_EQ(reward(-50.0), 0.0);  // outside the house
  EXPECT_NEAR(reward(-2.0), 0.5, 0.05);
}

TEST(Environment, AFailureIsWorthItsStepsAlone) {
  Task task = SmallTask();
  task.reward = RewardSpec{};
  Lanes lanes(task);
  lanes.environment.Reset(0, Ahead({3.0}), Room());
  const StepOutcome outcome = lanes.Step(Action::kStop);
  EXPECT_TRUE(outcome.terminated);
  EXPECT_EQ(outcome.reward, -0.001);
}

TEST(Environment, GoalsOfASequenceBeginWhereTheLastOneEnded) {
  Lanes lanes(SmallTask());
  Environment& environment = lanes.environment;
  environment.Reset(0, Ahead({1.5, 3.0}), Room());
  EXPECT_TRUE(environment.TakeNewGoal(0));
  EXPECT_FALSE(environment.TakeNewGoal(0));
  EXPECT_TRUE(environment.is_first_goal(0));
  const std::uint64_t first_seed = environment.agent_seed(0);
  const auto color = environment.goal(0).color;
  const std::vector<std::uint8_t> first(color.begin(), color.end());
  for (int i = 0; i < 2; ++i) lanes.Step(Action::kMoveForward);
  EXPECT_TRUE(lanes.Step(Action::kStop).terminated);
  EXPECT_FALSE(environment.is_over(0));
  EXPECT_TRUE(environment.TakeNewGoal(0));
  EXPECT_FALSE(environment.is_first_goal(0));
  EXPECT_NE(environment.agent_seed(0), first_seed);
  EXPECT_NE(
      std::vector<std::uint8_t>(environment.goal(0).color.begin(), environment.goal(0).color.end()),
      first);
  EXPECT_NEAR(lanes.truths[0].goal.position.z(), -4.0, 1e-9);
  environment.Fail(0, "gave up");
  const EpisodeResult result = environment.Finish(0, {}).result;
  EXPECT_NEAR(result.goals[1].Value("start_distance"), 2.5, 0.1);
  EXPECT_EQ(result.failure, "gave up");
}

TEST(Environment, GoalsThatTheBodyIsAtAlreadyAreOverWithoutAStep) {
  Task task = SmallTask();
  task.success.no_stop = true;
  Lanes lanes(task);
  lanes.environment.Reset(0, Ahead({0.5, 0.7, 2.0}), Room());
  EXPECT_FALSE(lanes.environment.is_over(0));
  EXPECT_NEAR(lanes.truths[0].goal.position.z(), -3.0, 1e-9);
  EXPECT_FALSE(lanes.environment.is_first_goal(0));
}

/// A random walk, and what is seen on it, as text.
class Walk {
 public:
  explicit Walk(int number) : rng_(5, "walk " + std::to_string(number)) {}
  Action Take(const agent::Observation& observation) {
    seen_.append(observation.panorama.color.begin(), observation.panorama.color.end());
    seen_ += std::to_string(observation.panorama.depth[100]);
    seen_ += std::to_string(observation.odometry.x);
    return rng_.Chance(0.7) ? Action::kMoveForward : Action::kTurnLeft;
  }
  const std::string& seen() const { return seen_; }

 private:
  sim::Rng rng_;
  std::string seen_;
};

/// Takes some lanes through walks, all together.
std::vector<std::string> WalkAll(Environment* environment, const std::vector<int>& lanes,
                                 std::vector<Walk> walks) {
  for (int step = 0; step < 30; ++step) {
    environment->Observe(lanes);
    std::vector<Action> actions;
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      actions.push_back(walks[i].Take(environment->observation(lanes[i])));
    }
    environment->Step(lanes, actions);
  }
  std::vector<std::string> seen;
  for (const Walk& walk : walks) seen.push_back(walk.seen());
  return seen;
}

void ExpectLanesAsIfAlone(const Task& task) {
  const auto room = Room();
  const auto other = Room("other");
  const auto world_of = [&](int i) {
    return i == 1 ? other : room;
  };
  std::vector<std::string> alone;
  for (int i = 0; i < 3; ++i) {
    Lanes lanes(task);
    lanes.environment.Reset(0, Ahead({2.0}, std::to_string(i)), world_of(i));
    alone.push_back(WalkAll(&lanes.environment, {0}, {Walk(i)}).front());
  }
  EXPECT_NE(alone[0], alone[2]);
  Lanes lanes(task, 3, 2);
  lanes.environment.Reset(2, Ahead({1.0}, "before"), other);
  lanes.Step(Action::kMoveForward, 2);
  for (int i = 0; i < 3; ++i) {
    lanes.environment.Reset(i, Ahead({2.0}, std::to_string(i)), world_of(i));
  }
  EXPECT_EQ(WalkAll(&lanes.environment, {0, 1, 2}, {Walk(0), Walk(1), Walk(2)}), alone);
}

TEST(Environment, LanesAreAsIfTheyWereAlone) {
  Task task = SmallTask();
  task.noise = sim::NoiseMode::kAnsReleased;
  ExpectLanesAsIfAlone(task);
  task.sensor_noise = sim::NamedSensorNoise("depth_camera");
  ExpectLanesAsIfAlone(task);
}

/// What three lanes see on a walk that one of them ends at its time limit, and what its steps came
/// to, as text; with observations read by Observe, or in the steps themselves.
std::string WalkToTheLimit(const Task& task, bool in_steps) {
  Lanes lanes(task, 3, 2);
  for (int i = 0; i < 3; ++i) {
    lanes.environment.Reset(i, Ahead({2.0, 1.0}, std::to_string(i)), Room());
  }
  const std::vector<int> all = {0, 1, 2};
  lanes.environment.Observe(all);
  std::vector<Walk> walks = {Walk(0), Walk(1), Walk(2)};
  std::string came;
  for (int step = 0; step < task.max_steps + 3; ++step) {
    std::vector<Action> actions;
    for (const int i : all) {
      actions.push_back(walks[static_cast<std::size_t>(i)].Take(lanes.environment.observation(i)));
    }
    const std::span<const StepOutcome> outcomes =
        in_steps ? lanes.environment.StepAndObserve(all, actions)
                 : lanes.environment.Step(all, actions);
    for (const StepOutcome& outcome : outcomes) {
      came += fmt::format("{} {} ", outcome.reward, outcome.truncated);
    }
    if (!in_steps) lanes.environment.Observe(all);
  }
  for (const Walk& walk : walks) came += walk.seen();
  return came;
}

TEST(Environment, StepsThatReadTheSensorsSeeTheSame) {
  Task task = SmallTask();
  task.noise = sim::NoiseMode::kAnsReleased;
  task.sensor_noise = sim::NamedSensorNoise("depth_camera");
  task.reward = RewardSpec{};
  task.max_steps = 20;
  const std::string apart = WalkToTheLimit(task, false);
  EXPECT_NE(apart.find(" true "), std::string::npos);
  EXPECT_EQ(WalkToTheLimit(task, true), apart);
}

/// Of one episode, its goals one after the other.
std::vector<std::vector<std::uint8_t>> GoalPictures(const Task& task, const std::string& id) {
  Lanes lanes(task);
  lanes.environment.Reset(0, Ahead({1.5, 1.5}, id), Room());
  std::vector<std::vector<std::uint8_t>> pictures;
  while (!lanes.environment.is_over(0)) {
    const agent::Panorama goal = lanes.environment.goal(0);
    pictures.emplace_back(goal.color.begin(), goal.color.end());
    lanes.Step(Action::kStop);
  }
  return pictures;
}

TEST(Environment, GoalsHaveTheSensorsNoiseToo) {
  Task task = SmallTask();
  const auto clean = GoalPictures(task, "a");
  task.sensor_noise = sim::NamedSensorNoise("phone_camera");
  const auto noisy = GoalPictures(task, "a");
  ASSERT_EQ(noisy.size(), 2u);
  EXPECT_EQ(clean[0], clean[1]);
  EXPECT_NE(noisy[0], clean[0]);
  EXPECT_NE(noisy[0], noisy[1]);
  EXPECT_EQ(noisy, GoalPictures(task, "a"));
  EXPECT_NE(noisy, GoalPictures(task, "b"));
}

TEST(Environment, GoalsLoseMirrorsToo) {
  Task task = SmallTask();
  task.sensor_noise = sim::NamedSensorNoise("depth_camera");
  sim::SceneMesh room = tests::BoxRoom(8, 2.6f, 8);
  const auto lost_with_walls_of = [&](const std::string& name) {
    for (sim::Material& material : room.materials) material.name = name;
    Lanes lanes(task);
    lanes.environment.Reset(0, Ahead({1.5}), sim::World::FromMesh(room, "room"));
    const std::span<const float> depth = lanes.environment.goal(0).depth;
    return std::count(depth.begin(), depth.end(), 0.0f);
  };
  EXPECT_LT(lost_with_walls_of("paint"), 16 * 64 / 4);
  EXPECT_GT(lost_with_walls_of("mirror"), 16 * 64 / 2);
}

void ExpectWhatASimulatorShows(const Task& task) {
  const auto room = Room();
  Lanes lanes(task);
  lanes.environment.Reset(0, Ahead({2.0}), room);
  sim::SimulatorSpec spec{task.body, task.panorama, task.noise};
  spec.sensor_noise = task.sensor_noise;
  sim::Simulator simulator(room, spec);
  const sim::EpisodeKey key = TaskEpisode(Ahead({2.0}), task, room).random_key();
  const sim::Observation* expected = &simulator.Reset(Ahead({2.0}).episode.start(), key);
  for (int i = 0; i < 5; ++i) {
    const int lane = 0;
    lanes.environment.Observe({&lane, 1});
    const agent::Observation seen = lanes.environment.observation(0);
    EXPECT_TRUE(std::equal(seen.panorama.color.begin(), seen.panorama.color.end(),
                           expected->color.begin(), expected->color.end()));
    EXPECT_TRUE(std::equal(seen.panorama.depth.begin(), seen.panorama.depth.end(),
                           expected->depth.begin(), expected->depth.end()));
    EXPECT_EQ(seen.step, i);
    lanes.Step(Action::kMoveForward);
    expected = &simulator.Step(Action::kMoveForward);
  }
  if (!task.sensor_noise.is_none()) return;
  const sim::Observation goal = sim::Simulator(room, {task.body, task.panorama, task.noise})
                                    .Reset(Ahead({2.0}).episode.goal(0));
  EXPECT_TRUE(
      std::equal(goal.color.begin(), goal.color.end(), lanes.environment.goal(0).color.begin()));
}

TEST(Environment, ShowsWhatASimulatorShows) {
  Task task = SmallTask();
  ExpectWhatASimulatorShows(task);
  task.sensor_noise = sim::NamedSensorNoise("stereo_camera");
  ExpectWhatASimulatorShows(task);
}

TEST(Environment, AnEpisodeThatCannotBePlayedIsNamedAndLeavesTheLaneEmpty) {
  Lanes lanes(SmallTask());
  EpisodeTask bad = Ahead({2.0}, "in the wall");
  bad.episode.start_position = {-3, 0, 3};
  try {
    lanes.environment.Reset(0, bad, Room());
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("episode 'in the wall' in room"));
  }
  EXPECT_FALSE(lanes.environment.has_episode(0));
  EXPECT_THROW(lanes.environment.is_over(0), sim::Error);
  lanes.environment.Reset(0, Ahead({2.0}), Room());
  EXPECT_FALSE(lanes.environment.is_over(0));
}

TEST(Environment, DrawsNothingForWhoDoesNotLook) {
  Task task = SmallTask();
  task.color = task.depth = false;
  Lanes lanes(task);
  lanes.environment.Reset(0, Ahead({2.0}), Room());
  const int lane = 0;
  lanes.environment.Observe({&lane, 1});
  EXPECT_TRUE(lanes.environment.observation(0).panorama.color.empty());
  EXPECT_TRUE(lanes.environment.goal(0).depth.empty());
}

}  // namespace
}  // namespace bulletnav::bench
