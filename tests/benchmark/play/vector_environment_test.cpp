// SPDX-License-Identifier: MIT
#include "benchmark/play/vector_environment.h"

#include <map>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

using sim::Action;
using testing::ElementsAre;

constexpr int kLanes = 3;

std::shared_ptr<const sim::World> Room(const std::string& name) {
  static std::map<std::string, std::shared_ptr<const sim::World>> rooms;
  auto& room = rooms[name];
  const float width = name == "wide" ? 10.0f : 8.0f;
  if (!room) room = sim::World::FromMesh(tests::BoxRoom(width, 2.6f, 8), name);
  return room;
}

/// Along -z, to a goal some metres ahead.
Episode Ahead(double metres, const std::string& scene = "room") {
  Episode episode;
  episode.id = std::to_string(metres);
  episode.scene = scene;
  episode.start_position = {1, 0, -1};
  EpisodeGoal& goal = episode.goals.emplace_back();
  goal.position = {1, 0, -1 - metres};
  goal.rotation = Rotation::FromYaw(0.0);
  return episode;
}

VectorSpec Spec(Autoreset autoreset = Autoreset::kNextStep, int threads = 1) {
  VectorSpec spec;
  spec.task.panorama.rows = 16;
  spec.task.panorama.cols = 64;
  spec.task.noise = sim::NoiseMode::kAnsReleased;
  spec.task.max_steps = 4;
  spec.task.reward = RewardSpec();
  spec.episodes = {Ahead(1.1), Ahead(2.0), Ahead(3.0, "wide"), Ahead(4.0)};
  spec.lanes = kLanes;
  spec.threads = threads;
  spec.autoreset = autoreset;
  return spec;
}

template <class T>
std::vector<T> Values(const VectorEnvironment& environment, const std::string& name) {
  for (std::size_t i = 0; i < environment.arrays().size(); ++i) {
    if (environment.arrays()[i].name != name) continue;
    const auto bytes = environment.memory(i);
    const auto* first = reinterpret_cast<const T*>(bytes.data());
    return {first, first + bytes.size() / sizeof(T)};
  }
  return {};
}

std::vector<std::string> Playing(const VectorEnvironment& environment) {
  std::vector<std::string> ids;
  for (int lane = 0; lane < environment.lanes(); ++lane) {
    ids.push_back(environment.episode(lane).id.substr(0, 1));
  }
  return ids;
}

const std::vector<Action> kForward(kLanes, Action::kMoveForward);

/// All that can be seen of some steps.
struct Trace {
  std::vector<std::vector<float>> depths;
  std::vector<std::vector<float>> goals;
  std::vector<double> rewards;
  bool operator==(const Trace&) const = default;
};

Trace Walk(const VectorSpec& spec, std::uint64_t seed) {
  VectorEnvironment environment(spec, Room);
  environment.Reset(seed);
  Trace trace;
  for (int step = 0; step < 14; ++step) {
    environment.Step(kForward);
    trace.depths.push_back(Values<float>(environment, "panorama.depth"));
    trace.goals.push_back(Values<float>(environment, "goal.depth"));
    trace.rewards.insert(trace.rewards.end(), environment.rewards().begin(),
                         environment.rewards().end());
  }
  return trace;
}

TEST(VectorEnvironment, IsAFunctionOfSpecSeedAndActions) {
  const Trace trace = Walk(Spec(), 1);
  EXPECT_EQ(Walk(Spec(Autoreset::kNextStep, 2), 1), trace);
  EXPECT_NE(Walk(Spec(), 2), trace);
}

TEST(VectorEnvironment, ALaneIsAnEnvironmentOfItsOwn) {
  VectorEnvironment environment(Spec(), Room);
  environment.Reset(1);
  GroundTruth truth;
  Environment alone(Spec().task, {&truth}, 1);
  EpisodeTask episode;
  episode.episode = Ahead(2.0);
  episode.key.seed = sim::MixSeed(1, 0);
  alone.Reset(0, episode, Room("room"));
  const int lane = 0;
  const std::size_t pixels = std::size_t{16} * 64;
  for (int step = 0; step < 3; ++step) {
    environment.Step(kForward);
    const Action action = Action::kMoveForward;
    const double reward = alone.Step({&lane, 1}, {&action, 1}).front().reward;
    EXPECT_EQ(environment.rewards()[1], reward);
    alone.Observe({&lane, 1});
    const auto all = Values<float>(environment, "panorama.depth");
    const auto expected = alone.observation(0).panorama.depth;
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), all.begin() + pixels));
  }
}

TEST(VectorEnvironment, LanesTakeEpisodesInTurnInTheNextStep) {
  VectorEnvironment environment(Spec(), Room);
  environment.Reset(0);
  EXPECT_THAT(Playing(environment), ElementsAre("1", "2", "3"));
  const auto goals = Values<float>(environment, "goal.depth");
  for (int step = 0; step < 4; ++step) environment.Step(kForward);
  EXPECT_THAT(environment.truncated(), ElementsAre(1, 1, 1));  // max_steps
  EXPECT_THAT(environment.terminated(), ElementsAre(0, 0, 0));
  ASSERT_EQ(environment.finished().size(), 3u);
  EXPECT_EQ(environment.finished()[2].result.key.scene, "wide");
  EXPECT_EQ(environment.finished()[2].result.goals[0].Whole("steps"), 4);
  EXPECT_THAT(Playing(environment), ElementsAre("1", "2", "3"));
  EXPECT_EQ(Values<float>(environment, "goal.depth"), goals);
  environment.Step(kForward);
  EXPECT_THAT(environment.truncated(), ElementsAre(0, 0, 0));
  EXPECT_THAT(environment.rewards(), ElementsAre(0.0, 0.0, 0.0));
  EXPECT_TRUE(environment.finished().empty());
  EXPECT_THAT(Playing(environment), ElementsAre("4", "1", "2"));
  EXPECT_NE(Values<float>(environment, "goal.depth"), goals);
}

TEST(VectorEnvironment, ASuccessfulStopTerminates) {
  VectorEnvironment environment(Spec(), Room);
  environment.Reset(0);
  environment.Step(kForward);
  environment.Step(std::vector{Action::kStop, Action::kStop, Action::kMoveForward});
  EXPECT_THAT(environment.terminated(), ElementsAre(1, 1, 0));
  EXPECT_GT(environment.rewards()[0], 5.0);
  EXPECT_LT(environment.rewards()[1], 0.0);
  EXPECT_TRUE(environment.finished()[0].result.goals[0].success());
  EXPECT_FALSE(environment.finished()[1].result.goals[0].success());
}

TEST(VectorEnvironment, InTheSameStepTheNextEpisodeIsSeen) {
  VectorEnvironment environment(Spec(Autoreset::kSameStep), Room);
  environment.Reset(0);
  for (int step = 0; step < 4; ++step) environment.Step(kForward);
  EXPECT_THAT(environment.truncated(), ElementsAre(1, 1, 1));
  EXPECT_THAT(Playing(environment), ElementsAre("4", "1", "2"));
}

TEST(VectorEnvironment, WithoutAutoresetLanesWait) {
  VectorEnvironment environment(Spec(Autoreset::kNever), Room);
  environment.Reset(0);
  environment.Step(std::vector{Action::kStop, Action::kMoveForward, Action::kMoveForward});
  EXPECT_THROW(environment.Step(kForward), sim::Error);
  environment.ResetLanes(std::vector{0});
  EXPECT_THAT(Playing(environment), ElementsAre("4", "2", "3"));
  environment.Step(kForward);
}

TEST(VectorEnvironment, SomeLanesStepAndOthersStay) {
  VectorEnvironment some(Spec(), Room);
  VectorEnvironment all(Spec(), Room);
  some.Reset(0);
  all.Reset(0);
  const std::vector<float> before = Values<float>(some, "panorama.depth");
  some.Step(std::vector{0, 2}, std::vector{Action::kMoveForward, Action::kMoveForward});
  all.Step(kForward);
  const std::vector<float> moved = Values<float>(some, "panorama.depth");
  const std::vector<float> expected = Values<float>(all, "panorama.depth");
  const std::ptrdiff_t lane = 16 * 64;
  EXPECT_TRUE(std::equal(moved.begin(), moved.begin() + lane, expected.begin()));
  EXPECT_TRUE(std::equal(moved.begin() + lane, moved.begin() + 2 * lane, before.begin() + lane));
  EXPECT_TRUE(std::equal(moved.begin() + 2 * lane, moved.end(), expected.begin() + 2 * lane));
  EXPECT_EQ(some.rewards()[2], all.rewards()[2]);
  EXPECT_EQ(some.rewards()[1], 0.0);
  const std::vector two = {Action::kStop, Action::kStop};
  EXPECT_THROW(some.Step(std::vector{2, 0}, two), sim::Error);
  EXPECT_THROW(some.Step(std::vector{0, 3}, two), sim::Error);
  EXPECT_THROW(some.Step(std::vector{0}, two), sim::Error);
}

TEST(VectorEnvironment, ShuffledPassesHoldEveryEpisodeOnce) {
  VectorSpec spec = Spec(Autoreset::kSameStep);
  spec.lanes = 1;
  spec.shuffle = true;
  VectorEnvironment environment(spec, Room);
  environment.Reset(3);
  std::vector<std::string> passes[2];
  for (int i = 0; i < 8; ++i) {
    passes[i / 4].push_back(Playing(environment)[0]);
    environment.Step(std::vector{Action::kStop});
  }
  EXPECT_NE(passes[0], passes[1]);
  EXPECT_THAT(passes[0], testing::UnorderedElementsAre("1", "2", "3", "4"));
  EXPECT_THAT(passes[1], testing::UnorderedElementsAre("1", "2", "3", "4"));
}

TEST(VectorEnvironment, MisuseThrows) {
  VectorSpec spec = Spec();
  spec.episodes.clear();
  EXPECT_THROW(VectorEnvironment(spec, Room), sim::Error);
  spec = Spec();
  spec.lanes = 0;
  EXPECT_THROW(VectorEnvironment(spec, Room), sim::Error);
  VectorEnvironment environment(Spec(), Room);
  EXPECT_THROW(environment.Step(kForward), sim::Error);
  EXPECT_THROW(environment.episode(0), sim::Error);
  environment.Reset(0);
  EXPECT_THROW(environment.Step(std::vector{Action::kStop}), sim::Error);
  EXPECT_THROW(environment.ResetLanes(std::vector{3}), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
