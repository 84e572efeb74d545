// SPDX-License-Identifier: MIT
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "agent/slam/topology/clusters.h"
#include "agent/slam/topology/sequences.h"

namespace bulletnav::agent {
namespace {

/// So many clouds of 30 points each, far apart.
Eigen::MatrixXf Clouds(int clouds) {
  sim::Rng rng(7, "clouds");
  Eigen::MatrixXf points(30 * clouds, 2);
  for (int i = 0; i < points.rows(); ++i) {
    const int cloud = i / 30;
    const double angle = 2.0 * M_PI * cloud / clouds;
    points(i, 0) = static_cast<float>(10.0 * std::cos(angle) + 0.3 * rng.Normal());
    points(i, 1) = static_cast<float>(10.0 * std::sin(angle) + 0.3 * rng.Normal());
  }
  return points;
}

TEST(ClusterPoints, FindsCloudsThatAreApart) {
  const Eigen::MatrixXf points = Clouds(5);
  sim::Rng rng(1, "test");
  const Clusters clusters = ClusterPoints(points, 5, 10, &rng);
  std::set<int> groups;
  for (int i = 0; i < points.rows(); ++i) {
    EXPECT_EQ(clusters.group[static_cast<std::size_t>(i)],
              clusters.group[static_cast<std::size_t>(i / 30 * 30)]);
    groups.insert(clusters.group[static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(groups.size(), 5u);
}

/// Every point is with its nearest centre, and centres are means: Lloyd's fixed point.
TEST(ClusterPoints, StopsWhereNothingChanges) {
  const Eigen::MatrixXf points = Clouds(6);
  sim::Rng rng(2, "test");
  const Clusters clusters = ClusterPoints(points, 4, 1, &rng);
  double spread = 0.0;
  for (int i = 0; i < points.rows(); ++i) {
    const Eigen::VectorXf distances =
        (clusters.centres.rowwise() - points.row(i)).rowwise().squaredNorm();
    const int group = clusters.group[static_cast<std::size_t>(i)];
    EXPECT_NEAR(distances(group), distances.minCoeff(), 1e-4);
    spread += distances(group);
  }
  EXPECT_NEAR(clusters.spread, spread, 1e-3 * spread);
}

TEST(ClusterPoints, IsAFunctionOfTheSeed) {
  const Eigen::MatrixXf points = Clouds(5);
  sim::Rng a(3, "test");
  sim::Rng b(3, "test");
  EXPECT_EQ(ClusterPoints(points, 7, 3, &a).group, ClusterPoints(points, 7, 3, &b).group);
}

TEST(ClusterPoints, PointsThatAreAllTheSameAreNoTrouble) {
  sim::Rng rng(4, "test");
  const Clusters clusters = ClusterPoints(Eigen::MatrixXf::Ones(8, 3), 4, 2, &rng);
  EXPECT_EQ(clusters.spread, 0.0);
}

TEST(Elbow, IsFarthestFromTheChord) {
  EXPECT_EQ(Elbow(std::vector<double>{100, 20, 15, 10, 5, 0}), 1);
  EXPECT_EQ(Elbow(std::vector<double>{100, 90, 5, 3, 0}), 2);
  EXPECT_EQ(Elbow(std::vector<double>{4, 2, 0}), 0);  // straight: nowhere
  EXPECT_EQ(Elbow(std::vector<double>{1}), 0);
  EXPECT_EQ(Elbow(std::vector<double>{1, 1, 1}), 0);
}

TEST(ClusterByElbow, FindsTheNumberOfClouds) {
  sim::Rng rng(5, "test");
  const Clusters clusters = ClusterByElbow(Clouds(6), {.most = 18, .step = 1, .starts = 10}, &rng);
  EXPECT_EQ(clusters.centres.rows(), 6);
}

TEST(ClusterByElbow, TakesAMultipleOfTheElbow) {
  sim::Rng rng(5, "test");
  const ElbowSpec twice{.most = 18, .step = 1, .starts = 10, .multiple = 2.0};
  const Clusters clusters = ClusterByElbow(Clouds(6), twice, &rng);
  EXPECT_EQ(clusters.centres.rows(), 12);
  EXPECT_EQ(clusters.tried.front(), 2);  // what was tried stays, for the picture
  sim::Rng again(5, "test");
  const ElbowSpec half{.most = 18, .step = 1, .starts = 10, .multiple = 0.5};
  EXPECT_EQ(ClusterByElbow(Clouds(6), half, &again).centres.rows(), 3);
}

TEST(ClusterByElbow, FewPointsAreOneGroup) {
  sim::Rng rng(6, "test");
  EXPECT_EQ(ClusterByElbow(Clouds(1).topRows(15), {}, &rng).centres.rows(), 1);
}

std::vector<std::pair<int, int>> Ends(const std::vector<int>& clusters, int shortest) {
  std::vector<std::pair<int, int>> ends;
  for (const Sequence& sequence : SequencesOf(clusters, shortest)) {
    ends.emplace_back(sequence.first, sequence.last);
  }
  return ends;
}

TEST(Sequences, AreRunsOfOneCluster) {
  using Expected = std::vector<std::pair<int, int>>;
  EXPECT_EQ(Ends({1, 1, 2, 1, 1, 1}, 1), (Expected{{0, 1}, {2, 2}, {3, 5}}));
  EXPECT_EQ(Ends({}, 1), Expected{});
}

TEST(Sequences, ShortRunsJoinANeighbour) {
  using Expected = std::vector<std::pair<int, int>>;
  EXPECT_EQ(Ends({1, 1, 1, 2, 1, 1, 1, 3, 3, 3}, 3), (Expected{{0, 6}, {7, 9}}));
  EXPECT_EQ(Ends({2, 1, 1, 1, 4}, 2), (Expected{{0, 4}}));
  EXPECT_EQ(Ends({1, 2, 3}, 2), (Expected{{0, 2}}));
}

}  // namespace
}  // namespace bulletnav::agent
