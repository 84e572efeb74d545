// SPDX-License-Identifier: MIT
#include "agent/policy/policy_agent.h"

#include <vector>

#include <gmock/gmock.h>

namespace bulletnav::agent {
namespace {

using ::testing::ElementsAre;

/// Says the probabilities that it was made with, and notes what it is asked.
class Stub final : public PolicyModel {
 public:
  explicit Stub(std::array<float, 4> says) : probabilities(says) {}
  int step_limit() const override { return 100; }
  std::vector<float> NoMemory() const override { return {0.0f}; }
  std::vector<float> CodeOf(const Panorama& goal) override {
    return {static_cast<float>(goal.color.front())};
  }
  std::array<float, 4> Act(const PolicyQuestion& question, std::vector<float>* memory) override {
    goals.push_back(question.goal.front());
    numbers.emplace_back(question.numbers.begin(), question.numbers.end());
    memories.push_back(memory->front());
    memory->front() += 1.0f;
    return probabilities;
  }

  std::vector<float> goals;
  std::vector<std::vector<float>> numbers;
  std::vector<float> memories;
  std::array<float, 4> probabilities;
};

class PolicyAgentTest : public testing::Test {
 protected:
  sim::Action Act(PolicyAgent* agent, int step, double x = 0.25) {
    Observation observation;
    observation.step = step;
    observation.odometry = {x, 0.0, 0.0};
    return agent->Act(observation);
  }
  const std::vector<std::uint8_t> seven_ = {7, 7, 7};
  const std::vector<std::uint8_t> eight_ = {8, 8, 8};
};

TEST_F(PolicyAgentTest, RemembersWithinAnEpisodeAndTellsWhatItDid) {
  const auto policy = std::make_shared<Stub>(std::array{0.0f, 0.0f, 0.0f, 1.0f});
  PolicyAgent agent({}, policy);
  agent.Reset({seven_, {}}, 1);
  EXPECT_EQ(Act(&agent, 0), sim::Action::kTurnRight);
  EXPECT_EQ(Act(&agent, 1), sim::Action::kTurnRight);
  EXPECT_THAT(policy->memories, ElementsAre(0.0f, 1.0f));
  EXPECT_THAT(policy->goals, ElementsAre(7.0f, 7.0f));
  EXPECT_THAT(policy->numbers[0], ElementsAre(0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(policy->numbers[1], ElementsAre(0, 0, 0, 1, 1, 0, 0, testing::FloatEq(0.01f)));
}

TEST_F(PolicyAgentTest, AnotherGoalIsAnotherEpisode) {
  const auto policy = std::make_shared<Stub>(std::array{0.0f, 1.0f, 0.0f, 0.0f});
  PolicyAgent agent({}, policy);
  agent.Reset({seven_, {}}, 1);
  Act(&agent, 0);
  Act(&agent, 1);
  agent.NextGoal({eight_, {}}, 2);
  Act(&agent, 2);
  Act(&agent, 3);
  EXPECT_THAT(policy->memories, ElementsAre(0.0f, 1.0f, 0.0f, 1.0f));
  EXPECT_THAT(policy->goals, ElementsAre(7.0f, 7.0f, 8.0f, 8.0f));
  EXPECT_EQ(policy->numbers[2], policy->numbers[0]);
  EXPECT_EQ(policy->numbers[3], policy->numbers[1]);
}

TEST_F(PolicyAgentTest, DrawsActionsByTheirProbabilities) {
  const auto policy = std::make_shared<Stub>(std::array{0.1f, 0.6f, 0.3f, 0.0f});
  PolicyAgent agent({}, policy);
  PolicyAgent likeliest({.sample = false}, policy);
  likeliest.Reset({seven_, {}}, 5);
  std::array<int, 4> counts{};
  for (int step = 0; step < 2000; ++step) {
    agent.Reset({seven_, {}}, static_cast<std::uint64_t>(step));  // a stop ends an episode
    ++counts[static_cast<std::size_t>(Act(&agent, step))];
    EXPECT_EQ(Act(&likeliest, step), sim::Action::kMoveForward);
  }
  EXPECT_NEAR(counts[0], 200, 50);
  EXPECT_NEAR(counts[1], 1200, 90);
  EXPECT_EQ(counts[3], 0);
}

TEST_F(PolicyAgentTest, StopsOnlyWhenItIsSureIfItIsToldSo) {
  PolicyAgent doubting({.stop_from = 0.5},
                       std::make_shared<Stub>(std::array{0.45f, 0.3f, 0.15f, 0.1f}));
  PolicyAgent sure({.stop_from = 0.5}, std::make_shared<Stub>(std::array{0.5f, 0.5f, 0.0f, 0.0f}));
  doubting.Reset({seven_, {}}, 5);
  sure.Reset({seven_, {}}, 5);
  for (int step = 0; step < 50; ++step) {
    EXPECT_NE(Act(&doubting, step), sim::Action::kStop);
  }
  EXPECT_EQ(Act(&sure, 0), sim::Action::kStop);
}

TEST_F(PolicyAgentTest, StopsOnlyAfterSoManySureStepsInARow) {
  const std::array doubts = {0.1f, 0.9f, 0.0f, 0.0f};
  const std::array sure = {0.6f, 0.4f, 0.0f, 0.0f};
  const auto policy = std::make_shared<Stub>(doubts);
  PolicyAgent agent({.stop_from = 0.5, .stop_steps = 3}, policy);
  agent.Reset({seven_, {}}, 5);
  int step = 0;
  const auto next = [&](std::array<float, 4> probabilities) {
    policy->probabilities = probabilities;
    return Act(&agent, step++);
  };
  EXPECT_EQ(next(sure), sim::Action::kMoveForward);
  EXPECT_EQ(next(sure), sim::Action::kMoveForward);
  EXPECT_EQ(next(doubts), sim::Action::kMoveForward);  // counted anew
  EXPECT_EQ(next(sure), sim::Action::kMoveForward);
  EXPECT_EQ(next(sure), sim::Action::kMoveForward);
  EXPECT_EQ(next(sure), sim::Action::kStop);
  agent.NextGoal({eight_, {}}, 6);
  EXPECT_EQ(next(sure), sim::Action::kMoveForward);
  EXPECT_EQ(next({1.0f, 0.0f, 0.0f, 0.0f}), sim::Action::kStop);  // there is nothing else to do
}

TEST_F(PolicyAgentTest, GoesOnAfterAStopInVain) {
  for (const double stop_from : {0.0, 0.5}) {
    const auto policy = std::make_shared<Stub>(std::array{1.0f, 0.0f, 0.0f, 0.0f});
    PolicyAgent agent({.stop_from = stop_from}, policy);
    agent.Reset({seven_, {}}, 5);
    EXPECT_EQ(Act(&agent, 0), sim::Action::kStop);
    policy->probabilities = {0.9f, 0.1f, 0.0f, 0.0f};
    for (int step = 1; step < 40; ++step) EXPECT_EQ(Act(&agent, step), sim::Action::kMoveForward);
    agent.NextGoal({eight_, {}}, 6);
    policy->probabilities = {1.0f, 0.0f, 0.0f, 0.0f};
    EXPECT_EQ(Act(&agent, 40), sim::Action::kStop);
  }
}

TEST_F(PolicyAgentTest, SureStepsNeedAProbabilityFromWhichTheyCount) {
  PolicyAgent::Config config;
  config.stop_steps = 4;
  EXPECT_THROW(config.Validate(), sim::Error);
  config.stop_from = 0.3;
  EXPECT_NO_THROW(config.Validate());
}

}  // namespace
}  // namespace bulletnav::agent
