// SPDX-License-Identifier: MIT
#include "agent/nts/nts_agent.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/agent/nts/scripted_model.h"
#include "tests/support/corridor.h"
#include "tests/support/rigs.h"

namespace bulletnav::agent {
namespace {

/// A body on an endless floor that sees nothing but what the model says; moves as it is told.
class NtsAgentTest : public testing::Test {
 protected:
  NtsAgentTest() {
    model_->encode = [this](const Panorama& panorama) {
      return panorama.depth.empty() ? CodeAt(goal_.x, goal_.y) : CodeAt(at_.x, at_.y, at_.yaw);
    };
    model_->is_open = [](const Point& /*from*/, double /*heading*/) {
      return true;
    };
    AgentContext context;
    context.rig = tests::SmallRig();
    context.models.Set("semantic_model", model_);
    NtsSpec spec;
    spec.policy.opening_reach = 0.0;  // known floor ends all around a body that sees nothing
    agent_ = std::make_unique<NtsAgent>(spec, context, GhostChoice::kScore);
  }

  /// Steps until it stops, or 300.
  int Run() {
    int steps = 0;
    for (; steps < 300; ++steps) {
      const sim::Action action = agent_->Act({{{}, depth_}, motion_, false, steps});
      if (action == sim::Action::kStop) break;
      constexpr double kTurn = sim::DegToRad(10.0);
      motion_ = {};
      if (action == sim::Action::kMoveForward) motion_.x = 0.25;
      if (action == sim::Action::kTurnLeft) motion_.yaw = kTurn;
      if (action == sim::Action::kTurnRight) motion_.yaw = -kTurn;
      at_ = sim::Compose(at_, motion_);
      walked_ += motion_.x;
    }
    motion_ = {};
    return steps;
  }
  double Left() const { return Distance({at_.x, at_.y}, goal_); }

  std::shared_ptr<ScriptedModel> model_ = std::make_shared<ScriptedModel>();
  std::unique_ptr<NtsAgent> agent_;
  std::vector<float> depth_ = std::vector<float>(8 * 32, 0.0f);
  sim::PlanarPose at_;
  sim::PlanarPose motion_;
  Point goal_;
  double walked_ = 0.0;
};

TEST_F(NtsAgentTest, FollowsTheScoresToAGoalFarOffAndStopsThere) {
  goal_ = {7, 5};
  agent_->Reset({}, 3);
  const int steps = Run();
  EXPECT_LT(steps, 100);
  EXPECT_LE(Left(), 0.6);
  EXPECT_LT(walked_, 1.25 * std::hypot(7, 5));
  EXPECT_EQ(model_->encoded, steps + 2);  // the goal, and each observation once
}

TEST_F(NtsAgentTest, RemembersTheGraphForTheNextGoal) {
  goal_ = {9, 0};
  agent_->Reset({}, 3);
  Run();
  const std::size_t nodes = agent_->belief().graph->nodes.size();
  goal_ = {0.5, 0};
  walked_ = 0.0;
  agent_->NextGoal({}, 4);
  Run();
  EXPECT_LE(Left(), 0.6);
  EXPECT_LT(walked_, 1.1 * 8.5);
  EXPECT_GE(agent_->belief().graph->nodes.size(), nodes);
}

TEST_F(NtsAgentTest, ShowsItsGraphAndTheChosenPath) {
  goal_ = {7, 5};
  agent_->Reset({}, 3);
  agent_->Act({{{}, depth_}, {}, false, 0});
  const Belief belief = agent_->belief();
  ASSERT_TRUE(belief.graph && belief.target && belief.map);
  ASSERT_EQ(belief.graph->path.size(), 2u);
  EXPECT_EQ(belief.graph->path[0], 0);
  EXPECT_TRUE(belief.graph->nodes[static_cast<std::size_t>(belief.graph->path[1])].is_ghost);
}

TEST_F(NtsAgentTest, ShowsNoPathOnceItWalksToTheGoalItself) {
  goal_ = {7, 5};
  agent_->Reset({}, 3);
  Run();
  const Belief belief = agent_->belief();
  ASSERT_TRUE(belief.graph && belief.target);
  EXPECT_TRUE(belief.graph->path.empty()) << "the one it was on before";
  EXPECT_NEAR(belief.target->x, 7.0, 0.6);
}

TEST_F(NtsAgentTest, GivesUpAGoalThatIsNotWhereANodeSaidItIs) {
  goal_ = {0, 20};
  model_->sees = [](const Point& a, const Point& b) {
    const bool is_lie = Distance(a, {0, 0}) < 0.01 && b.y > 19.0;
    return is_lie || Distance(a, b) <= kNodeRadius;
  };
  agent_->Reset({}, 3);
  EXPECT_LT(Run(), 200);
  EXPECT_LE(Left(), 0.6);
}

TEST(NtsAgent, GoesWhereKnownFloorEndsIfNoDirectionIsExplorable) {
  const auto model = std::make_shared<ScriptedModel>();
  model->encode = [](const Panorama& panorama) {
    return panorama.depth.empty() ? CodeAt(6, 0) : CodeAt(0, 0);
  };
  AgentContext context;
  context.models.Set("semantic_model", model);
  NtsSpec spec;
  spec.policy.opening_reach = 4.0;
  NtsAgent agent(spec, context, GhostChoice::kScore);
  agent.Reset({}, 3);
  const auto depth = tests::CorridorDepth(0.0);
  agent.Act({{{}, depth}, {}, false, 0});
  const GraphPicture graph = *agent.belief().graph;
  ASSERT_EQ(graph.path.size(), 2u);
  EXPECT_EQ(graph.path[0], 0);
  const GraphPicture::Node& ghost = graph.nodes[static_cast<std::size_t>(graph.path[1])];
  EXPECT_TRUE(ghost.is_ghost);
  EXPECT_NEAR(ghost.x, 3.0, 0.3) << "the end of what is seen of the corridor";
}

TEST(NtsAgent, AsksTheMapBeforeItWalksToAGhostBehindAWall) {
  for (const bool has_walls : {false, true}) {
    const auto model = std::make_shared<ScriptedModel>();
    model->encode = [](const Panorama& panorama) {
      return panorama.depth.empty() ? CodeAt(0, 6) : CodeAt(0, 0);
    };
    model->is_open = [](const Point& /*from*/, double heading) {
      return std::cos(heading) > 0.9 || std::sin(heading) > 0.9;
    };
    AgentContext context;
    context.models.Set("semantic_model", model);
    NtsSpec spec;
    spec.policy.opening_reach = 0.0;
    spec.policy.path_weight = 1.0;
    NtsAgent agent(spec, context, GhostChoice::kScore);
    agent.Reset({}, 3);
    const auto corridor = tests::CorridorDepth(0.0);
    const std::vector<float> nothing(corridor.size(), 0.0f);
    agent.Act({{{}, has_walls ? corridor : nothing}, {}, false, 0});
    const Belief belief = agent.belief();
    ASSERT_TRUE(belief.graph && belief.target);
    ASSERT_EQ(belief.graph->path.size(), 2u);
    EXPECT_NEAR(belief.target->x, has_walls ? 3.0 : 0.0, 0.1);
    EXPECT_NEAR(belief.target->y, has_walls ? 0.0 : 3.0, 0.1);
  }
}

TEST(NtsAgent, WithoutAModelSaysWhereToNameOne) {
  AgentContext context;
  context.rig = tests::SmallRig();
  try {
    const NtsAgent agent(NtsSpec{}, context, GhostChoice::kScore);
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_NE(std::string(e.what()).find("semantic_model"), std::string::npos);
  }
}

}  // namespace
}  // namespace bulletnav::agent
