// SPDX-License-Identifier: MIT
#include "agent/nts/settle_graph.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

using sim::PlanarPose;
using Edge = PoseEdge<PlanarPose>;

/// Half the sum of squared errors, by the definition in pose_graph.h.
double CostOf(const PlanarPoseGraph& graph) {
  double cost = 0.0;
  for (const Edge& edge : graph.edges) {
    const PlanarPose& from = graph.vertices[static_cast<std::size_t>(edge.from)].pose;
    const PlanarPose& to = graph.vertices[static_cast<std::size_t>(edge.to)].pose;
    const PlanarPose off = Compose(Inverse(edge.measured), Compose(Inverse(from), to));
    const Eigen::Vector3d error(off.x, off.y, off.yaw);
    cost += 0.5 * error.dot(edge.information * error);
  }
  return cost;
}

Eigen::Matrix3d Diagonal(double x, double y, double yaw) {
  return Eigen::Vector3d(x, y, yaw).asDiagonal();
}

/// A walk with loops, measured with noise; the last vertex is fixed where odometry has it.
PlanarPoseGraph Walk(std::uint64_t seed, double noise, std::vector<PlanarPose>* truth) {
  sim::Rng rng(seed, "settle");
  const auto off = [&](double size) {
    return PlanarPose{size * rng.Normal(), size * rng.Normal(), size * rng.Normal()};
  };
  truth->assign(1, {});
  PlanarPoseGraph graph;
  graph.vertices.push_back({0, {}, false});
  const auto join = [&](int from, int to, bool is_loop) {
    const PlanarPose seen = Compose(Inverse((*truth)[static_cast<std::size_t>(from)]),
                                    (*truth)[static_cast<std::size_t>(to)]);
    graph.edges.push_back({from, to, Compose(seen, off(noise)), Diagonal(900, 400, 2500), is_loop});
  };
  for (int i = 1; i < 40; ++i) {
    truth->push_back(Compose(truth->back(), {rng.Uniform(0.5, 2.0), 0.0, rng.Uniform(-1.5, 1.5)}));
    join(i - 1, i, false);
    graph.vertices.push_back(
        {i, Compose(graph.vertices.back().pose, graph.edges.back().measured), false});
  }
  for (int i = 0; i < 25; ++i) join(rng.Below(20), 20 + rng.Below(20), true);
  graph.vertices.back().is_fixed = true;
  return graph;
}

TEST(SettleGraph, ALoopSpreadsItsErrorOverTheWay) {
  PlanarPoseGraph graph;
  graph.vertices.push_back({0, {}, true});
  for (int i = 1; i <= 3; ++i) {
    graph.vertices.push_back({i, {1.0 * i, 0.0, 0.0}, false});
    graph.edges.push_back({i - 1, i, {1.0, 0.0, 0.0}, Diagonal(100, 100, 100)});
  }
  graph.edges.push_back({0, 3, {3.4, 0.0, 0.0}, Diagonal(100, 100, 100), true});
  SettleGraph({.kernel_width = 1e6}, &graph);
  for (int i = 0; i <= 3; ++i) {
    const PlanarPose& pose = graph.vertices[static_cast<std::size_t>(i)].pose;
    EXPECT_NEAR(pose.x, 1.1 * i, 1e-6);
    EXPECT_NEAR(pose.y, 0.0, 1e-9);
    EXPECT_NEAR(pose.yaw, 0.0, 1e-9);
  }
}

TEST(SettleGraph, WithoutNoiseTheTruthIsFoundAgain) {
  std::vector<PlanarPose> truth;
  PlanarPoseGraph graph = Walk(1, 0.0, &truth);
  sim::Rng rng(2, "settle");
  for (std::size_t i = 0; i + 1 < graph.vertices.size(); ++i) {
    PlanarPose& pose = graph.vertices[i].pose;
    pose = {pose.x + 0.05 * rng.Normal(), pose.y + 0.05 * rng.Normal(),
            pose.yaw + 0.03 * rng.Normal()};
  }
  SettleGraph({.kernel_width = 1e6, .rounds = 20}, &graph);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(graph.vertices[i].pose.x, truth[i].x, 1e-6) << i;
    EXPECT_NEAR(graph.vertices[i].pose.y, truth[i].y, 1e-6) << i;
  }
}

TEST(SettleGraph, NoStepFromWhereItSettlesCostsLess) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::vector<PlanarPose> truth;
    PlanarPoseGraph graph = Walk(seed, 0.05, &truth);
    const double before = CostOf(graph);
    const PlanarPose fixed = graph.vertices.back().pose;
    SettleGraph({.kernel_width = 1e6, .rounds = 30}, &graph);
    const double cost = CostOf(graph);
    EXPECT_LT(cost, 0.5 * before);
    EXPECT_EQ(graph.vertices.back().pose.x, fixed.x);
    EXPECT_EQ(graph.vertices.back().pose.yaw, fixed.yaw);
    for (std::size_t i = 0; i + 1 < graph.vertices.size(); i += 3) {
      for (const double by : {1e-3, -1e-3}) {
        for (int k = 0; k < 3; ++k) {
          PlanarPoseGraph other = graph;
          PlanarPose& pose = other.vertices[i].pose;
          (k == 0 ? pose.x : k == 1 ? pose.y : pose.yaw) += by;
          EXPECT_GE(CostOf(other), cost - 1e-9) << seed << " " << i << " " << k;
        }
      }
    }
  }
}

TEST(SettleGraph, AWrongLoopBendsLittle) {
  std::vector<PlanarPose> truth;
  PlanarPoseGraph graph = Walk(3, 0.01, &truth);
  SettleGraph({}, &graph);
  PlanarPoseGraph wrong = graph;
  wrong.edges.push_back({2, 35, {0.0, 0.0, 0.0}, Diagonal(100, 100, 100), true});
  ASSERT_GT(std::hypot(truth[2].x - truth[35].x, truth[2].y - truth[35].y), 3.0);
  SettleGraph({}, &wrong);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(wrong.vertices[i].pose.x, graph.vertices[i].pose.x, 0.15) << i;
    EXPECT_NEAR(wrong.vertices[i].pose.y, graph.vertices[i].pose.y, 0.15) << i;
  }
}

TEST(SettleGraph, OneVertexStays) {
  PlanarPoseGraph graph;
  graph.vertices.push_back({0, {1.0, 2.0, 3.0}, true});
  SettleGraph({}, &graph);
  EXPECT_EQ(graph.vertices[0].pose.yaw, 3.0);
}

}  // namespace
}  // namespace bulletnav::agent
