// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "agent/policy/exploration_policy.h"
#include "agent/policy/exploration_view.h"
#include "sim/base/error.h"
#include "tests/support/scenes.h"
#include "tests/support/trials.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;

/// Always the same place of the window, sure of it.
class OneGoal final : public ExplorationPolicy {
 public:
  explicit OneGoal(const std::array<double, 2>& mean) : mean_(mean) {}
  GoalDistribution Ask(std::span<const std::uint8_t> view, int heading) override {
    EXPECT_EQ(view.size(), kExplorationBytes);
    EXPECT_TRUE(heading >= 0 && heading < kHeadings);
    ++asked;
    return {mean_, {0.01, 0.01}};
  }
  int asked = 0;

 private:
  std::array<double, 2> mean_;
};

sim::SimulatorSpec Quiet() {
  sim::SimulatorSpec spec;
  spec.noise = sim::NoiseMode::kNone;
  spec.color = false;
  return spec;
}

AgentMaker With(std::shared_ptr<ExplorationPolicy> policy, const std::string& config = "") {
  AgentMaker maker = config.empty()
                         ? ConfigureAgent("active_neural_slam")
                         : ConfigureAgent("active_neural_slam", sim::ParseYaml(config, "c.yaml"));
  return [maker, policy](std::span<const AgentContext> contexts) {
    std::vector<AgentContext> all(contexts.begin(), contexts.end());
    if (policy) {
      for (AgentContext& context : all) context.models.Set("exploration", policy);
    }
    return maker(all);
  };
}

/// The goal is round the corner at the end of the corridor; the body looks along the first part.
tests::Trial RoundTheCorner() {
  return {{{1, 0, -0.7}, -sim::kPi / 2}, {{7.2, 0, -6}, 0.0}, 11.6, {}};
}

TEST(ActiveNeuralSlam, ExploresByItsPolicyAndStopsAtTheGoal) {
  const auto world = sim::World::FromMesh(tests::LCorridor(8, 7, 1.5f, 2.6f), "corridor");
  sim::Simulator simulator(world, Quiet());
  const auto ahead = std::make_shared<OneGoal>(std::array{3.0, 1.0});
  const tests::TrialResult result = tests::RunTrial(&simulator, RoundTheCorner(), With(ahead));
  EXPECT_TRUE(result.success());
  EXPECT_GT(result.spl(), 0.8);
  EXPECT_GE(ahead->asked, 1);
  EXPECT_LE(ahead->asked, 1 + result.steps / 10);  // a goal is kept for some steps
}

TEST(ActiveNeuralSlam, GoalsAtRandomNeedNoPolicy) {
  const auto world = sim::World::FromMesh(tests::LCorridor(8, 7, 1.5f, 2.6f), "corridor");
  sim::Simulator simulator(world, Quiet());
  const AgentMaker maker = With(nullptr, "random_goal: true");
  const tests::TrialResult result = tests::RunTrial(&simulator, RoundTheCorner(), maker);
  EXPECT_TRUE(result.success());
  const tests::TrialResult again = tests::RunTrial(&simulator, RoundTheCorner(), maker);
  EXPECT_EQ(again.steps, result.steps);
}

TEST(ActiveNeuralSlam, SaysWhatIsMissing) {
  const auto expect = [](const AgentMaker& maker, const char* what) {
    AgentContext context;
    context.models.Set("exploration", std::make_shared<OneGoal>(std::array{0.0, 0.0}));
    try {
      maker(std::array{context});
      FAIL();
    } catch (const sim::Error& e) {
      EXPECT_THAT(e.what(), HasSubstr(what));
    }
  };
  expect(With(nullptr), "semantic_model");
  try {
    ConfigureAgent("active_neural_slam", sim::ParseYaml("navigator: {map: {size: 13}}", "c.yaml"));
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("24 m"));
  }
}

}  // namespace
}  // namespace bulletnav::agent
