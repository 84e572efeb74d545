// SPDX-License-Identifier: MIT
#include "agent/slam/pose_graph/optimize.h"

#include <array>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/agent/slam/pose_graph/random_graph.h"

namespace bulletnav::agent {
namespace {

using sim::PlanarPose;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using tests::Moved;
using tests::Numbers;
using tests::PoseVector;
using tests::RandomGraph;

Eigen::Matrix3d Diagonal(double x, double y, double yaw) {
  return Eigen::Vector3d(x, y, yaw).asDiagonal();
}

TEST(Optimize, ALoopSpreadsItsErrorByInformation) {
  constexpr int kEdges = 7;
  PlanarPoseGraph graph;
  graph.vertices.push_back({0, {}});
  double give = 0.0;  // sum of variances
  std::vector<double> variances;
  for (int i = 0; i < kEdges; ++i) {
    variances.push_back(0.01 * (1 + i % 3));
    give += variances.back();
    graph.vertices.push_back({i + 1, {1.0 + i, 0.0, 0.0}});
    graph.edges.push_back({i, i + 1, {1.0, 0.0, 0.0}, Diagonal(1.0 / variances.back(), 5.0, 20.0)});
  }
  constexpr double kClosing = 0.05;
  constexpr double kError = 0.4;
  graph.edges.push_back(
      {0, kEdges, {kEdges + kError, 0.0, 0.0}, Diagonal(1.0 / kClosing, 5.0, 20.0), true});
  const OptimizeSummary summary = Optimize({}, &graph);
  EXPECT_TRUE(summary.converged);
  double x = 0.0;
  for (int i = 0; i < kEdges; ++i) {
    const double share = variances[static_cast<std::size_t>(i)] / (give + kClosing);
    x += 1.0 + share * kError;
    const PlanarPose& pose = graph.vertices[static_cast<std::size_t>(i) + 1].pose;
    EXPECT_NEAR(pose.x, x, 1e-6);
    EXPECT_NEAR(pose.y, 0.0, 1e-9);
    EXPECT_NEAR(pose.yaw, 0.0, 1e-9);
  }
  EXPECT_NEAR(summary.initial_cost, 0.5 * kError * kError / kClosing, 1e-9);
  EXPECT_NEAR(summary.final_cost, 0.5 * kError * kError / (give + kClosing), 1e-9);
}

/// Correlated measurements of one pose, with their frames alike, make a linear problem.
TEST(Optimize, TwoCorrelatedMeasurementsGiveTheirWeightedMean) {
  Eigen::Matrix3d first;
  first << 4.0, 1.5, 0.2, 1.5, 2.0, -0.6, 0.2, -0.6, 3.0;
  Eigen::Matrix3d second;
  second << 1.0, -0.7, 0.1, -0.7, 3.0, 0.9, 0.1, 0.9, 2.0;
  const Eigen::Vector3d a(1.0, 2.0, 0.0);
  const Eigen::Vector3d b(2.0, 1.0, 0.0);
  PlanarPoseGraph graph;
  graph.vertices = {{0, {}}, {1, {0.0, 0.0, 0.3}}};
  graph.edges = {{0, 1, {a.x(), a.y(), 0.0}, first}, {0, 1, {b.x(), b.y(), 0.0}, second}};
  const OptimizeSummary summary = Optimize({}, &graph);
  const Eigen::Vector3d mean = (first + second).inverse() * (first * a + second * b);
  EXPECT_LT((Numbers(graph.vertices[1].pose) - mean).norm(), 1e-6);
  const double cost =
      0.5 * (mean - a).dot(first * (mean - a)) + 0.5 * (mean - b).dot(second * (mean - b));
  EXPECT_NEAR(summary.final_cost, cost, 1e-9);

  // What weighting with L instead of its transpose would give is somewhere else.
  const auto wrong = [](const Eigen::Matrix3d& information) -> Eigen::Matrix3d {
    const Eigen::Matrix3d l = information.llt().matrixL();
    return l.transpose() * l;
  };
  const Eigen::Vector3d mistake =
      (wrong(first) + wrong(second)).inverse() * (wrong(first) * a + wrong(second) * b);
  EXPECT_GT((mistake - mean).norm(), 0.05);
}

/// Half the sum of squares, worked out from the definition of PoseEdge.
template <class Pose>
PoseVector<Pose> ErrorOf(const PoseEdge<Pose>& edge, const Pose& from, const Pose& to) {
  return Numbers(Compose(Inverse(edge.measured), Compose(Inverse(from), to)));
}

/// Slow and simple: Gauss and Newton's method with differences for derivatives and one full matrix.
/// Keeps the first vertex. Returns the cost at the end.
template <class Pose>
double GaussNewton(PoseGraph<Pose>* graph) {
  constexpr int kSize = kFreedoms<Pose>;
  constexpr double kStep = 1e-6;
  const auto at = [&](std::int64_t id) {
    return static_cast<Eigen::Index>((id - 10) / 3);
  };
  const auto size = static_cast<Eigen::Index>(graph->vertices.size()) * kSize;
  double cost = 0.0;
  for (int i = 0; i < 30; ++i) {
    cost = 0.0;
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
    for (const PoseEdge<Pose>& edge : graph->edges) {
      const Pose from = graph->vertices[static_cast<std::size_t>(at(edge.from))].pose;
      const Pose to = graph->vertices[static_cast<std::size_t>(at(edge.to))].pose;
      const PoseVector<Pose> e = ErrorOf(edge, from, to);
      Eigen::MatrixXd j = Eigen::MatrixXd::Zero(kSize, size);
      for (int k = 0; k < kSize; ++k) {
        const PoseVector<Pose> d = kStep * PoseVector<Pose>::Unit(k);
        j.col(at(edge.from) * kSize + k) +=
            (ErrorOf(edge, Moved<Pose>(from, d), to) - ErrorOf(edge, Moved<Pose>(from, -d), to)) /
            (2 * kStep);
        j.col(at(edge.to) * kSize + k) +=
            (ErrorOf(edge, from, Moved<Pose>(to, d)) - ErrorOf(edge, from, Moved<Pose>(to, -d))) /
            (2 * kStep);
      }
      h += j.transpose() * edge.information * j;
      g += j.transpose() * edge.information * e;
      cost += 0.5 * e.dot(edge.information * e);
    }
    const Eigen::Index rest = size - kSize;
    const Eigen::VectorXd step = h.bottomRightCorner(rest, rest).ldlt().solve(-g.tail(rest));
    for (std::size_t v = 1; v < graph->vertices.size(); ++v) {
      const PoseVector<Pose> d = step.segment<kSize>(static_cast<Eigen::Index>(v - 1) * kSize);
      graph->vertices[v].pose = Moved<Pose>(graph->vertices[v].pose, d);
    }
  }
  return cost;
}

template <class Pose>
void ExpectSame(const PoseGraph<Pose>& a, const PoseGraph<Pose>& b, double within) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const Pose between = Compose(Inverse(a.vertices[i].pose), b.vertices[i].pose);
    EXPECT_LT(Numbers(between).norm(), within) << "vertex " << i;
  }
}

template <class Pose>
class OptimizeAll : public ::testing::Test {};
using Poses = ::testing::Types<PlanarPose, SpatialPose>;
TYPED_TEST_SUITE(OptimizeAll, Poses);

TYPED_TEST(OptimizeAll, AgreesWithASmallSolver) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto graph = RandomGraph<TypeParam>(seed, 12, 10, 0.05);
    auto reference = graph;
    const double cost = GaussNewton(&reference);
    const OptimizeSummary summary = Optimize({}, &graph);
    EXPECT_TRUE(summary.converged);
    EXPECT_LT(summary.final_cost, 0.9 * summary.initial_cost);
    EXPECT_NEAR(summary.final_cost, cost, 1e-7 * cost) << "seed " << seed;
    ExpectSame(graph, reference, 1e-5);
  }
}

TYPED_TEST(OptimizeAll, WithoutNoiseCostsNothing) {
  auto graph = RandomGraph<TypeParam>(1, 30, 20, 1e-9);
  for (auto& edge : graph.edges) edge.information.setIdentity();
  auto bent = graph;
  sim::Rng rng(3, "bend");
  for (std::size_t i = 1; i < bent.vertices.size(); ++i) {
    bent.vertices[i].pose =
        Moved(bent.vertices[i].pose, tests::RandomNumbers<TypeParam>(0.1, &rng));
  }
  const OptimizeSummary summary = Optimize({}, &bent);
  EXPECT_GT(summary.initial_cost, 0.1);
  EXPECT_LT(summary.final_cost, 1e-12);
  ExpectSame(graph, bent, 1e-6);
}

TYPED_TEST(OptimizeAll, GivesTheSameBytesTwice) {
  const auto graph = RandomGraph<TypeParam>(5, 200, 300, 0.05);
  auto first = graph;
  auto second = graph;
  Optimize({}, &first);
  Optimize({}, &second);
  for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
    EXPECT_EQ(Numbers(first.vertices[i].pose), Numbers(second.vertices[i].pose));
  }
}

TYPED_TEST(OptimizeAll, KeepsWhatIsFixedAndElseTheFirstOfAPiece) {
  auto graph = RandomGraph<TypeParam>(6, 10, 8, 0.05);
  const std::size_t half = graph.vertices.size();
  const auto other = RandomGraph<TypeParam>(7, 10, 8, 0.05);
  for (auto vertex : other.vertices) {
    vertex.id += 1000;
    graph.vertices.push_back(vertex);
  }
  for (auto edge : other.edges) {
    edge.from += 1000;
    edge.to += 1000;
    graph.edges.push_back(edge);
  }
  graph.vertices[half + 4].is_fixed = true;
  auto moved = graph;
  EXPECT_EQ(Optimize({.allow_pieces = true}, &moved).pieces, 2);
  const auto way = [&](std::size_t i) {
    return Numbers(Compose(Inverse(graph.vertices[i].pose), moved.vertices[i].pose)).norm();
  };
  EXPECT_LT(way(0), 1e-12);
  EXPECT_GT(way(half - 1), 1e-6);
  EXPECT_GT(way(half), 1e-6);
  EXPECT_LT(way(half + 4), 1e-12);
}

TYPED_TEST(OptimizeAll, TellsWhatIsWrong) {
  using Graph = PoseGraph<TypeParam>;
  const Graph good = RandomGraph<TypeParam>(8, 5, 2, 0.05);
  const auto expect = [&](const Graph& graph, const std::string& what) {
    EXPECT_THAT(
        [&] {
          Graph copy = graph;
          Optimize({}, &copy);
        },
        ThrowsMessage<sim::Error>(HasSubstr(what)));
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  expect({}, "no vertices");
  Graph bad = good;
  bad.edges[1].to = 99;
  expect(bad, "edge 2 from 13 to 99: there is no vertex 99; add it");
  bad = good;
  bad.edges[0].to = 10;
  expect(bad, "joins a vertex to itself");
  bad = good;
  bad.vertices[2].id = 10;
  expect(bad, "vertex 10 is there twice");
  bad = good;
  bad.edges[3].information(0, 0) = kNan;
  expect(bad, "edge 4 from 19 to 22: the information is not finite");
  bad = good;
  bad.edges[0].information(0, 1) += 1.0 + std::abs(bad.edges[0].information(0, 1));
  expect(bad, "not symmetric");
  bad = good;
  bad.edges[0].information(1, 1) = -1.0;
  expect(bad, "not positive definite");
  bad = good;
  bad.edges.erase(bad.edges.begin() + 3, bad.edges.end());
  expect(bad, "in 2 pieces: no edges lead from vertex 10 to vertex 22 and its piece of 1");
}

TEST(Optimize, TellsPosesThatAreNone) {
  PlanarPoseGraph planar;
  planar.vertices = {{4, {0.0, std::nan(""), 0.0}}};
  EXPECT_THAT(
      [&] {
        Optimize({}, &planar);
      },
      ThrowsMessage<sim::Error>(HasSubstr("vertex 4: the pose is not finite")));
  SpatialPoseGraph spatial;
  spatial.vertices = {{4, {}}};
  spatial.vertices[0].pose.rotation.coeffs() *= 1.1;
  EXPECT_THAT(
      [&] {
        Optimize({}, &spatial);
      },
      ThrowsMessage<sim::Error>(HasSubstr("vertex 4: the quaternion is not of length 1")));
  spatial.vertices[0].pose = {};
  EXPECT_THAT(
      [&] {
        Optimize({.kernel_width = 0.0}, &spatial);
      },
      ThrowsMessage<sim::Error>(HasSubstr("width must be positive")));
}

/// Large enough for the other factorisation, and bent far; without noise it all fits together.
TEST(Optimize, StraightensALargeGraph) {
  auto graph = RandomGraph<PlanarPose>(11, 2500, 200, 1e-9);
  for (auto& edge : graph.edges) edge.information.setIdentity();
  const auto truth = graph;
  sim::Rng rng(3, "bend");
  for (std::size_t i = 1; i < graph.vertices.size(); ++i) {
    graph.vertices[i].pose =
        Moved(graph.vertices[i].pose, tests::RandomNumbers<PlanarPose>(0.05, &rng));
  }
  const OptimizeSummary summary = Optimize({}, &graph);
  EXPECT_TRUE(summary.converged);
  EXPECT_LT(summary.final_cost, 1e-9);
  ExpectSame(graph, truth, 1e-4);
}

TEST(Optimize, OneVertexIsAGraph) {
  PlanarPoseGraph graph;
  graph.vertices = {{4, {1.0, 2.0, 3.0}}};
  const OptimizeSummary summary = Optimize({}, &graph);
  EXPECT_EQ(summary.final_cost, 0.0);
  EXPECT_EQ(graph.vertices[0].pose.y, 2.0);
}

TEST(Optimize, InThePlaneSpaceGivesTheSame) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    PlanarPoseGraph flat = RandomGraph<PlanarPose>(seed, 20, 15, 0.05);
    SpatialPoseGraph high;
    for (const auto& vertex : flat.vertices)
      high.vertices.push_back({vertex.id, InSpace(vertex.pose)});
    for (const auto& edge : flat.edges) {
      PoseMatrix<SpatialPose> information = PoseMatrix<SpatialPose>::Identity();
      constexpr std::array<int, 3> kInPlane = {0, 1, 5};
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          information(kInPlane[static_cast<std::size_t>(r)],
                      kInPlane[static_cast<std::size_t>(c)]) = edge.information(r, c);
        }
      }
      high.edges.push_back({edge.from, edge.to, InSpace(edge.measured), information, edge.is_loop});
    }
    const OptimizeOptions options = {.kernel = RobustKernel::kHuber, .kernel_width = 1.0};
    const OptimizeSummary in_plane = Optimize(options, &flat);
    const OptimizeSummary in_space = Optimize(options, &high);
    EXPECT_NEAR(in_plane.initial_cost, in_space.initial_cost, 1e-9 * in_plane.initial_cost);
    EXPECT_NEAR(in_plane.final_cost, in_space.final_cost, 1e-7 * in_plane.final_cost);
    for (std::size_t i = 0; i < flat.vertices.size(); ++i) {
      const SpatialPose between =
          Compose(Inverse(InSpace(flat.vertices[i].pose)), high.vertices[i].pose);
      EXPECT_LT(Numbers(between).norm(), 2e-5);
    }
  }
}

/// Odometry says 0, a loop says 10, both with a standard deviation of 1.
double WhereALoopPulls(RobustKernel kernel) {
  PlanarPoseGraph graph;
  graph.vertices = {{0, {}}, {1, {}}};
  graph.edges = {{0, 1, {}}, {0, 1, {10.0, 0.0, 0.0}, Eigen::Matrix3d::Identity(), true}};
  Optimize({.kernel = kernel, .kernel_width = 1.0}, &graph);
  return graph.vertices[1].pose.x;
}

TEST(Optimize, KernelsHoldLoopsBack) {
  EXPECT_NEAR(WhereALoopPulls(RobustKernel::kNone), 5.0, 1e-6);
  EXPECT_NEAR(WhereALoopPulls(RobustKernel::kHuber), 1.0, 1e-4);
  const double x = WhereALoopPulls(RobustKernel::kCauchy);
  EXPECT_LT(x, 0.2);
  EXPECT_NEAR(x, (10.0 - x) / (1.0 + (10.0 - x) * (10.0 - x)), 1e-4);
}

TEST(Optimize, SaysWhenItDidNotConverge) {
  auto graph = RandomGraph<SpatialPose>(9, 40, 40, 0.3);
  const OptimizeSummary summary = Optimize({.max_iterations = 1}, &graph);
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.iterations, 1);
}

}  // namespace
}  // namespace bulletnav::agent
