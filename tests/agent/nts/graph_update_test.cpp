// SPDX-License-Identifier: MIT
#include "agent/nts/graph_update.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/agent/nts/scripted_model.h"

namespace bulletnav::agent {
namespace {

class GraphUpdateTest : public testing::Test {
 protected:
  /// Observes at a place that odometry knows exactly.
  const Localisation& See(double x, double y, double yaw = 0.0) {
    return update_.Observe(CodeAt(x, y, yaw), {x, y, yaw});
  }
  void Walk(const Point& from, const Point& to) {
    const int steps = static_cast<int>(Distance(from, to) / 0.25);
    for (int i = 1; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      See(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y));
    }
  }
  std::vector<int> GhostDirections(int owner) const {
    std::vector<int> directions;
    for (const GhostNode& ghost : update_.graph().ghosts()) {
      if (ghost.owner == owner) directions.push_back(ghost.direction);
    }
    return directions;
  }

  std::shared_ptr<ScriptedModel> model_ = std::make_shared<ScriptedModel>();
  GraphUpdate update_{GraphSpec{}, model_};
};

TEST_F(GraphUpdateTest, TheFirstObservationIsANodeWithAGhostInEveryOpenDirection) {
  model_->is_open = [](const Point& /*from*/, double heading) {
    return std::fabs(sim::WrapAngle(heading - sim::kPi / 2)) < 0.1;
  };
  const Localisation& here = See(1, 1, sim::kPi / 3);
  EXPECT_EQ(here.current, 0);
  EXPECT_TRUE(here.is_new);
  EXPECT_EQ(GhostDirections(0), std::vector<int>{1});
  EXPECT_FALSE(See(1, 1, sim::kPi / 3).is_new);
}

TEST_F(GraphUpdateTest, NodesFollowEachOtherWhereTheLastOneCannotSee) {
  See(0, 0);
  Walk({0, 0}, {10, 0});
  const TopologicalGraph& graph = update_.graph();
  // 3 m are still seen from a node, and the second step beyond makes one.
  ASSERT_EQ(graph.nodes().size(), 3u);
  EXPECT_NEAR(graph.NodePoint(1).x, 3.5, 1e-9);
  EXPECT_NEAR(graph.NodePoint(2).x, 7.0, 1e-9);
  EXPECT_EQ(graph.edges().size(), 2u);
  EXPECT_TRUE(graph.HasEdge(0, 1) && graph.HasEdge(1, 2));
}

TEST_F(GraphUpdateTest, OneStepThatNoNodeKnowsIsNoNode) {
  See(0, 0);
  model_->sees = [](const Point& /*a*/, const Point& /*b*/) {
    return false;
  };
  EXPECT_EQ(See(0.25, 0).current, 0);
  EXPECT_EQ(update_.graph().nodes().size(), 1u);
  EXPECT_EQ(See(0.5, 0).current, 1);
}

TEST_F(GraphUpdateTest, ComingBackIsLocalisedAndClosesTheLoop) {
  See(0, 0);
  Walk({0, 0}, {3.5, 0});
  Walk({3.5, 0}, {3.5, 3.5});
  Walk({3.5, 3.5}, {0, 3.5});
  const std::size_t nodes = update_.graph().nodes().size();
  Walk({0, 3.5}, {0, 0});
  EXPECT_EQ(update_.graph().nodes().size(), nodes);
  EXPECT_EQ(update_.localisation().current, 0);
  EXPECT_TRUE(update_.graph().HasEdge(0, static_cast<int>(nodes) - 1));
}

TEST_F(GraphUpdateTest, ThePresentNodeIsKeptUntilAnotherIsClearlyNearer) {
  See(0, 0);
  Walk({0, 0}, {3.5, 0});
  EXPECT_EQ(See(1.75, 0).current, 1);
  EXPECT_EQ(See(1.6, 0).current, 1);
  EXPECT_EQ(See(1.4, 0).current, 0);
  EXPECT_EQ(See(1.8, 0).current, 0);
  EXPECT_TRUE(update_.localisation().Sees(0) && update_.localisation().Sees(1));
}

TEST_F(GraphUpdateTest, GhostsGiveWayToRegularNodesBothWays) {
  model_->is_open = [](const Point& /*from*/, double heading) {
    return std::fabs(std::sin(heading)) < 0.1;  // a corridor along x
  };
  See(0, 0);
  EXPECT_EQ(GhostDirections(0), (std::vector<int>{0, 6}));
  Walk({0, 0}, {3.5, 0});
  EXPECT_EQ(GhostDirections(0), std::vector<int>{6});
  EXPECT_EQ(GhostDirections(1), std::vector<int>{0});
}

TEST_F(GraphUpdateTest, GhostsNearAPlaceVisitedAreNoNews) {
  model_->is_open = [](const Point& from, double heading) {
    return from.x < 1.0 && std::fabs(sim::WrapAngle(heading)) < 0.1;
  };
  See(0, 0);
  See(0.5, 0.0);
  update_.MakeNode(CodeAt(2.5, 0.8), {2.5, 0.8, 0.0});
  EXPECT_TRUE(update_.graph().ghosts().empty());
}

TEST_F(GraphUpdateTest, NodesFarOffByOdometryAreNotAsked) {
  See(0, 0);
  Walk({0, 0}, {30, 0});
  model_->compared = 0;
  See(30, 0);
  EXPECT_LE(model_->compared, 3);
}

/// A body whose odometry turns it too far at each corner goes around a square again and again.
TEST(GraphUpdate, ClosesLoopsIfAsked) {
  const auto off_after_rounds = [](bool close) {
    auto model = std::make_shared<ScriptedModel>();
    GraphSpec spec;
    spec.loops.close = close;
    spec.loops.certainty = 0.9;  // of which the scripted model is sure
    GraphUpdate update(spec, model);
    sim::PlanarPose truth;
    sim::PlanarPose odometry;
    Point beside{1.0, 0.5};  // hangs on the first node
    const auto see = [&] {
      update.Observe(CodeAt(truth.x, truth.y, truth.yaw), odometry);
      beside = update.MovedWith(0, beside);
    };
    see();
    for (int side = 0; side < 24; ++side) {
      for (int i = 0; i < 24; ++i) {
        truth = Compose(truth, {0.25, 0.0, 0.0});
        odometry = Compose(odometry, {0.25, 0.0, 0.0});
        see();
      }
      truth = Compose(truth, {0.0, 0.0, sim::kPi / 2});
      odometry = Compose(odometry, {0.0, 0.0, sim::kPi / 2 + 0.02});
      see();
    }
    const sim::PlanarPose from_node =
        Compose(Inverse(update.graph().nodes()[0].pose), {beside.x, beside.y, 0.0});
    EXPECT_NEAR(from_node.x, 1.0, 1e-9) << "what hangs on a node goes with it";
    EXPECT_NEAR(from_node.y, 0.5, 1e-9);
    // The first node, where the body should be now, as seen from it.
    const sim::PlanarPose first = Compose(Inverse(odometry), update.graph().nodes()[0].pose);
    return std::hypot(first.x, first.y);
  };
  EXPECT_GT(off_after_rounds(false), 1.0);
  EXPECT_LT(off_after_rounds(true), 0.5);
}

TEST_F(GraphUpdateTest, ResetForgets) {
  See(0, 0);
  update_.Reset();
  EXPECT_EQ(See(0, 0).current, 0);
  EXPECT_EQ(update_.graph().nodes().size(), 1u);
}

}  // namespace
}  // namespace bulletnav::agent
