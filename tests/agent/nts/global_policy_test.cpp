// SPDX-License-Identifier: MIT
#include "agent/nts/global_policy.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/agent/nts/scripted_model.h"

namespace bulletnav::agent {
namespace {

/// Nodes every 2.5 m along x, the body at the first.
class GlobalPolicyTest : public testing::Test {
 protected:
  GlobalPolicyTest() {
    for (int i = 0; i < 4; ++i) {
      graph_.AddNode({CodeAt(2.5 * i, 0), {2.5 * i, 0, 0}});
      if (i > 0) graph_.AddEdge(i - 1, i);
    }
    here_.current = 0;
    here_.visible = {{0, 0.0}};
  }

  std::optional<Subgoal> Choose(GlobalPolicy* policy, const Point& at = {}) {
    policy->Read(&graph_);
    return policy->Choose(graph_, here_, at, approach_);
  }
  GlobalPolicy Policy(const Point& goal, GhostChoice choice = GhostChoice::kScore,
                      std::uint64_t seed = 1) {
    GlobalPolicy policy(spec_, model_, choice);
    policy.NewGoal(CodeAt(goal.x, goal.y), seed);
    return policy;
  }

  PolicySpec spec_;
  std::shared_ptr<ScriptedModel> model_ = std::make_shared<ScriptedModel>();
  TopologicalGraph graph_;
  Localisation here_;
  GoalApproach approach_{ApproachSpec{}};
};

TEST_F(GlobalPolicyTest, LeadsToTheNodeThatKnowsTheGoalNodeByNode) {
  GlobalPolicy policy = Policy({10.0, 0});
  const auto first = Choose(&policy);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->path, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_FALSE(first->ghost);
  EXPECT_NEAR(first->point.x, 2.5, 1e-9);
  EXPECT_NEAR(first->way, 10.0, 1e-6);
  here_ = {3, {{3, 0.0}}, false};
  const auto last = Choose(&policy, {7.5, 0});
  EXPECT_TRUE(last->is_last());
  EXPECT_NEAR(last->point.x, 10.0, 1e-6);
}

TEST_F(GlobalPolicyTest, SkipsNodesOnTheWayThatSeeTheBodyOrAreReached) {
  GlobalPolicy policy = Policy({10.0, 0});
  here_.visible = {{0, 1.0}, {1, 1.5}};
  EXPECT_EQ(Choose(&policy, {1.0, 0})->path, (std::vector<int>{1, 2, 3}));
  here_.visible = {{0, 2.3}};
  EXPECT_EQ(Choose(&policy, {2.3, 0})->path, (std::vector<int>{1, 2, 3}));
}

TEST_F(GlobalPolicyTest, DoesNotBelieveANodeThatWasWrong) {
  GlobalPolicy policy = Policy({10.0, 0});
  ASSERT_TRUE(Choose(&policy));
  policy.Refute(3);
  EXPECT_FALSE(Choose(&policy));
  policy.NewGoal(CodeAt(10.0, 0), 1);
  EXPECT_TRUE(Choose(&policy));
}

TEST_F(GlobalPolicyTest, BelievesNoNodeAboutAPlaceThatWasLookedAtInVain) {
  GlobalPolicy policy = Policy({10.0, 0});
  ASSERT_TRUE(Choose(&policy));
  for (int i = 0; i < 2; ++i) approach_.RefuteAt({10.2, 0.1});
  EXPECT_FALSE(Choose(&policy));
  graph_.AddNode({CodeAt(9.0, 1.0), {9.0, 1.0, 0}});
  graph_.AddEdge(3, 4);
  EXPECT_FALSE(Choose(&policy)) << "a node that was not asked before says the same";
}

TEST_F(GlobalPolicyTest, AGhostOfThePresentNodeIsAsFarOffAsItIsEvenIfTheNodeIsNotSeen) {
  const int ghost = graph_.AddGhost(0, 0);
  GlobalPolicy policy = Policy({30.0, 0});
  here_.visible = {};
  const auto subgoal = Choose(&policy, {2.5, 0});
  ASSERT_EQ(subgoal->ghost, ghost);
  EXPECT_NEAR(subgoal->way, 0.5, 1e-6);
}

TEST_F(GlobalPolicyTest, ExploresTheGhostOverWhichTheWholeWayIsShortest) {
  spec_.path_weight = 1.0;
  const int behind = graph_.AddGhost(0, 6);
  const int far = graph_.AddGhost(3, 0);
  GlobalPolicy policy = Policy({16.0, 0});
  const auto to_far = Choose(&policy);
  EXPECT_EQ(to_far->ghost, far);
  EXPECT_NEAR(to_far->way, 10.5, 1e-6);
  EXPECT_NEAR(to_far->all, 16.0, 1e-4);
  EXPECT_NEAR(*graph_.FindGhost(far)->score, 1.0 - 5.5 / 20.0, 1e-6);
  GlobalPolicy other = Policy({-7.0, 0});
  EXPECT_EQ(Choose(&other)->ghost, behind);
}

TEST_F(GlobalPolicyTest, WithoutPathWeightOnlyTheScoreCounts) {
  graph_.AddGhost(0, 3);
  const int far = graph_.AddGhost(3, 3);
  const Point goal{4.5, 9.0};  // nearer to the far one, but not by the way there
  GlobalPolicy weighed = Policy(goal);
  EXPECT_NE(Choose(&weighed)->ghost, far);
  spec_.path_weight = 0.0;
  GlobalPolicy plain = Policy(goal);
  EXPECT_EQ(Choose(&plain)->ghost, far);
}

TEST_F(GlobalPolicyTest, KeepsAGhostUnlessAnotherIsBetterByTheMargin) {
  for (const double margin : {0.1, 2.0}) {
    spec_.change_margin = margin;
    GlobalPolicy policy = Policy({20.0, 0});
    const int first = graph_.AddGhost(0, 11);
    ASSERT_EQ(Choose(&policy)->ghost, first);
    const int better = graph_.AddGhost(0, 0);  // by 0.47 m
    EXPECT_EQ(Choose(&policy)->ghost, margin > 0.47 ? first : better);
    graph_.RemoveGhost(first);
    graph_.RemoveGhost(better);
  }
}

TEST_F(GlobalPolicyTest, RandomGhostsComeFromTheSeedAndAreKept) {
  for (int i = 2; i < 11; ++i) graph_.AddGhost(0, i);
  std::set<int> chosen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    GlobalPolicy policy = Policy({30.0, 0}, GhostChoice::kRandom, seed);
    const int ghost = *Choose(&policy)->ghost;
    EXPECT_EQ(Choose(&policy)->ghost, ghost);
    GlobalPolicy same = Policy({30.0, 0}, GhostChoice::kRandom, seed);
    EXPECT_EQ(Choose(&same)->ghost, ghost);
    chosen.insert(ghost);
  }
  EXPECT_GT(chosen.size(), 4u);
}

TEST_F(GlobalPolicyTest, HasNowhereToGoWithoutGhostsOrWayThere) {
  GlobalPolicy policy = Policy({30.0, 0});
  EXPECT_FALSE(Choose(&policy));
  graph_.AddGhost(3, 0);
  EXPECT_TRUE(Choose(&policy));
  graph_.RemoveEdge(1, 2);
  EXPECT_FALSE(Choose(&policy));
}

TEST_F(GlobalPolicyTest, AsksAboutEachNodeOnce) {
  GlobalPolicy policy = Policy({30.0, 0});
  Choose(&policy);
  Choose(&policy);
  EXPECT_EQ(model_->compared, 4);
}

}  // namespace
}  // namespace bulletnav::agent
