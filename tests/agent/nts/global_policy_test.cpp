// SPDX-License-Identifier: MIT
#include "agent/nts/global_policy.h"

#include <cmath>
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
  std::optional<Subgoal> Follow(GlobalPolicy* policy, const Point& at = {}) {
    const auto subgoal = Choose(policy, at);
    if (subgoal) policy->Follow(*subgoal);
    return subgoal;
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
  GlobalPolicy other = Policy({10.0, 0});
  here_.visible = {{0, 2.3}};
  EXPECT_EQ(Choose(&other, {2.3, 0})->path, (std::vector<int>{1, 2, 3}));
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

TEST_F(GlobalPolicyTest, ANodeThatSawTheBodyAMomentAgoStillDoes) {
  graph_.AddGhostAt(1, {1.5, 1.0});
  GlobalPolicy policy = Policy({30.0, 0});
  here_.visible = {{0, 1.5}, {1, 1.5}};
  ASSERT_TRUE(Choose(&policy, {1.0, 0.5})->is_last());
  here_.visible = {{0, 1.5}};
  const auto subgoal = Choose(&policy, {1.2, 0.6});
  EXPECT_TRUE(subgoal->is_last()) << "not by way of node 1";
  EXPECT_NEAR(subgoal->way, 0.5, 1e-6);
  EXPECT_FALSE(Choose(&policy, {1.0, 1.6})->is_last()) << "it has moved 1.1 m since";
  GlobalPolicy other = Policy({30.0, 0});
  EXPECT_FALSE(Choose(&other, {1.2, 0.6})->is_last()) << "it was never seen from there";
}

TEST_F(GlobalPolicyTest, DoesNotTurnBackToANodeThatItHasPassed) {
  GlobalPolicy policy = Policy({10.0, 0});
  here_.visible = {{1, 2.2}};
  const std::vector<int> rest = {2, 3};
  ASSERT_EQ(Choose(&policy, {4.7, 0})->path, rest) << "node 2 is reached";
  EXPECT_EQ(Choose(&policy, {5.6, 0})->path, rest) << "and behind";
  here_.visible = {{0, 2.9}};
  EXPECT_EQ(Choose(&policy, {5.65, 0})->path, rest);
}

TEST_F(GlobalPolicyTest, TakesUpTheWayFromWhicheverNodeSeesTheBodyNow) {
  GlobalPolicy policy = Policy({10.0, 0});
  here_.visible = {{0, 1.0}};
  ASSERT_EQ(Choose(&policy, {1.0, 0})->path, (std::vector<int>{0, 1, 2, 3}));
  here_.visible = {{0, 1.2}, {1, 1.3}};
  EXPECT_EQ(Choose(&policy, {1.2, 0})->path, (std::vector<int>{1, 2, 3}));
}

TEST_F(GlobalPolicyTest, GoesElsewhereIfTheWayToAGhostTurnsOutToBeLong) {
  const int ahead = graph_.AddGhost(0, 0);
  const int aside = graph_.AddGhost(0, 3);
  spec_.path_weight = 1.0;
  GlobalPolicy policy = Policy({20.0, 0});
  ASSERT_EQ(Choose(&policy)->ghost, ahead);
  policy.known_ways().Learn({}, {3.0, 0}, 11.0);
  EXPECT_EQ(Choose(&policy)->ghost, aside);
  policy.known_ways().Learn({}, {3.0, 0}, 3.0);
  EXPECT_EQ(Choose(&policy)->ghost, ahead) << "there is a shorter way now";
}

TEST_F(GlobalPolicyTest, AsksNeighboursOfTheOwnerThatAreNeitherNearNorFar) {
  graph_.AddNode({CodeAt(6.0, 1.5), {6.0, 1.5, 0}});  // not joined to the owner
  graph_.AddNode({CodeAt(5.0, 2.5), {5.0, 2.5, 0}});  // too near
  graph_.AddNode({CodeAt(5.0, 7.6), {5.0, 7.6, 0}});  // too far
  graph_.AddEdge(2, 5);
  graph_.AddEdge(6, 2);
  model_->score = [](const Point& from, double heading, const Point& /*goal*/) {
    if (from.x == 7.5) return std::cos(heading) < -0.4 ? 0.3 : 0.0;  // towards the ghost
    if (from.x == 2.5) return 0.6;
    return from.y == 0.0 ? 0.9 : 0.1;
  };
  const int ghost = graph_.AddGhost(2, 3);
  for (const double weight : {0.0, 0.5, 1.0}) {
    spec_.neighbour_weight = weight;
    GlobalPolicy policy = Policy({30.0, 0});
    policy.Read(&graph_);
    // Nodes 1 and 3 are joined to the owner and 3.9 m from the ghost.
    const double mean = (0.9 + weight * (0.6 + 0.3)) / (1.0 + 2.0 * weight);
    EXPECT_NEAR(*graph_.FindGhost(ghost)->score, mean, 1e-6) << weight;
  }
}

TEST_F(GlobalPolicyTest, PricesAGhostOfTheViewAsIfTheViewWereANode) {
  spec_.path_weight = 1.0;
  model_->score = [](const Point& /*from*/, double /*heading*/, const Point& /*goal*/) {
    return 0.5;
  };
  GlobalPolicy policy = Policy({30.0, 0});
  const Point here{2.5, 0.5};
  here_.visible = {{1, 0.5}};
  Choose(&policy, here);
  const ViewGhost seen{0.0, 3.0, 0.8, 0.0};
  const Point point{3.5, 3.3};
  const double mean = (0.8 + 0.5 * 0.5) / 1.5;
  const auto all = [&] {
    return policy.AllOfView(graph_, here_, here, seen, point);
  };
  EXPECT_NEAR(all(), WayByGhost(spec_, 3.0, mean), 1e-6);
  policy.known_ways().Learn(here, point, 7.0);
  EXPECT_NEAR(all(), WayByGhost(spec_, 7.0, mean), 1e-6);
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
    ASSERT_EQ(Follow(&policy)->ghost, first);
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
    const int ghost = *Follow(&policy)->ghost;
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
