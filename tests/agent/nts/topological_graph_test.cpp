// SPDX-License-Identifier: MIT
#include "agent/nts/topological_graph.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "agent/perception/relative_pose.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

using Starts = std::vector<std::pair<int, double>>;

TopologicalGraph RandomGraph(sim::Rng* rng, int nodes, double density) {
  TopologicalGraph graph;
  for (int i = 0; i < nodes; ++i) {
    graph.AddNode({{}, {rng->Uniform(0.0, 9.0), rng->Uniform(0.0, 9.0), 0.0}});
  }
  for (int a = 0; a < nodes; ++a) {
    for (int b = a + 1; b < nodes; ++b) {
      if (rng->Chance(density)) graph.AddEdge(a, b);
    }
  }
  return graph;
}

/// All shortest ways, slowly.
std::vector<std::vector<double>> AllCosts(const TopologicalGraph& graph) {
  const std::size_t n = graph.nodes().size();
  std::vector<std::vector<double>> cost(n, std::vector<double>(n, INFINITY));
  for (std::size_t i = 0; i < n; ++i) cost[i][i] = 0.0;
  for (const GraphEdge& edge : graph.edges()) {
    const auto a = static_cast<std::size_t>(edge.a);
    const auto b = static_cast<std::size_t>(edge.b);
    cost[a][b] = cost[b][a] = std::hypot(edge.b_from_a.x, edge.b_from_a.y);
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        cost[i][j] = std::min(cost[i][j], cost[i][k] + cost[k][j]);
      }
    }
  }
  return cost;
}

TEST(TopologicalGraph, FindsShortestWaysInRandomGraphs) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    sim::Rng rng(seed, "graph");
    const TopologicalGraph graph = RandomGraph(&rng, 12, 0.18);
    const auto expected = AllCosts(graph);
    const GraphRoutes routes = graph.Routes(Starts{{0, 0.0}, {1, 2.5}});
    for (int i = 0; i < 12; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double cost = std::min(expected[0][k], expected[1][k] + 2.5);
      if (std::isinf(cost)) {
        EXPECT_EQ(routes.cost[k], cost);
        continue;
      }
      EXPECT_NEAR(routes.cost[k], cost, 1e-9);
      const std::vector<int> way = routes.To(i);
      double length = way.front() == 0 ? 0.0 : 2.5;
      for (std::size_t step = 1; step < way.size(); ++step) {
        EXPECT_TRUE(graph.HasEdge(way[step - 1], way[step]));
        length += Distance(graph.NodePoint(way[step - 1]), graph.NodePoint(way[step]));
      }
      EXPECT_EQ(way.back(), i);
      EXPECT_NEAR(length, cost, 1e-9);
    }
  }
}

TEST(TopologicalGraph, EdgesHoldTheRelativePose) {
  TopologicalGraph graph;
  graph.AddNode({{}, {1.0, 2.0, sim::kPi / 2}});
  graph.AddNode({{}, {1.0, 4.0, sim::kPi}});
  graph.AddEdge(0, 1);
  graph.AddEdge(1, 0);
  ASSERT_EQ(graph.edges().size(), 1u);
  EXPECT_NEAR(graph.edges()[0].b_from_a.x, 2.0, 1e-12);
  EXPECT_NEAR(graph.edges()[0].b_from_a.y, 0.0, 1e-12);
  EXPECT_NEAR(graph.edges()[0].b_from_a.yaw, sim::kPi / 2, 1e-12);
  graph.RemoveEdge(1, 0);
  EXPECT_FALSE(graph.HasEdge(0, 1));
}

TEST(TopologicalGraph, NodesMoveWithTheirGhostsAndEdges) {
  TopologicalGraph graph;
  graph.AddNode({{}, {0.0, 0.0, 0.0}});
  graph.AddNode({{}, {2.0, 0.0, 0.0}});
  graph.AddEdge(0, 1);
  const int ghost = graph.AddGhost(1, 0);
  graph.MoveNodes(std::vector<sim::PlanarPose>{{1.0, 0.0, 0.0}, {1.0, 3.0, sim::kPi / 2}});
  EXPECT_NEAR(graph.NodePoint(1).y, 3.0, 1e-12);
  EXPECT_NEAR(graph.edges()[0].b_from_a.y, 3.0, 1e-12);
  EXPECT_NEAR(graph.edges()[0].b_from_a.yaw, sim::kPi / 2, 1e-12);
  EXPECT_NEAR(graph.Routes(std::vector<std::pair<int, double>>{{0, 0.0}}).cost[1], 3.0, 1e-12);
  const Point point = graph.GhostPoint(*graph.FindGhost(ghost));
  EXPECT_NEAR(point.x, 1.0, 1e-6);
  EXPECT_NEAR(point.y, 3.0 + kNodeRadius, 1e-6);
}

TEST(TopologicalGraph, GhostsLieCounterClockwiseFromStraightAheadOfTheirOwner) {
  TopologicalGraph graph;
  graph.AddNode({{}, {1.0, 2.0, sim::kPi / 2}});
  const int left = graph.AddGhost(0, 3);
  EXPECT_EQ(graph.AddGhost(0, 3), left);
  const int ahead = graph.AddGhost(0, 0, 1.5);
  EXPECT_NEAR(graph.GhostPoint(*graph.FindGhost(left)).x, -2.0, 1e-12);
  EXPECT_NEAR(graph.GhostPoint(*graph.FindGhost(left)).y, 2.0, 1e-12);
  EXPECT_NEAR(graph.GhostPoint(*graph.FindGhost(ahead)).y, 3.5, 1e-12);
  graph.RemoveGhost(left);
  EXPECT_EQ(graph.FindGhost(left), nullptr);
  EXPECT_NE(graph.AddGhost(0, 3), left);
}

TEST(TopologicalGraph, PicturesNodesThenGhostsWithScores) {
  TopologicalGraph graph;
  graph.AddNode({{}, {0.0, 0.0, 0.0}});
  graph.AddNode({{}, {2.0, 0.0, 0.0}});
  graph.AddEdge(0, 1);
  graph.SetScore(graph.AddGhost(1, 0), 0.5);
  const GraphPicture picture = graph.Picture();
  ASSERT_EQ(picture.nodes.size(), 3u);
  EXPECT_TRUE(picture.nodes[2].is_ghost);
  EXPECT_NEAR(picture.nodes[2].x, 5.0, 1e-12);
  EXPECT_EQ(picture.nodes[2].score, 0.5);
  const std::vector<std::pair<int, int>> edges = {{0, 1}, {1, 2}};
  EXPECT_EQ(picture.edges, edges);
}

TEST(TopologicalGraph, AGhostAtAPointStaysThere) {
  sim::Rng rng(7, "ghosts");
  TopologicalGraph graph;
  graph.AddNode({{}, {1.0, -2.0, 0.7}});
  for (int i = 0; i < 100; ++i) {
    const Point point{rng.Uniform(-3.0, 5.0), rng.Uniform(-6.0, 2.0)};
    const GhostNode ghost = *graph.FindGhost(graph.AddGhostAt(0, point));
    EXPECT_LT(Distance(graph.GhostPoint(ghost), point), 1e-9);
    EXPECT_EQ(ghost.direction, DirectionOf(graph.BearingFrom(0, point)));
    EXPECT_LE(std::fabs(ghost.off), sim::kPi / kDirections + 1e-9);
  }
  EXPECT_EQ(graph.ghosts().size(), 100u) << "several in a direction";
}

}  // namespace
}  // namespace bulletnav::agent
