// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/math/rng.h"

namespace bulletnav::agent {

/// Points in groups about their means.
struct Clusters {
  Eigen::MatrixXf centres;      // a row each
  std::vector<int> group;       // by point
  double spread = 0.0;          // sum of squared distances to the centres
  std::vector<int> tried;       // by ClusterByElbow: numbers of groups
  std::vector<double> spreads;  // and how far each of them spread
};

/// Of some starts, centres drawn far from each other, the one whose groups, once nothing changes or
/// after 100 rounds, spread least. Points are rows. Groups that become empty keep their centre.
/// Expects: 1 <= k <= points, starts >= 1 (checked). Cost: starts x rounds x points x k x columns.
/// Source: Lloyd, 1982; seeds by Arthur and Vassilvitskii, "k-means++", SODA 2007.
Clusters ClusterPoints(const Eigen::MatrixXf& points, int k, int starts, sim::Rng* rng);

/// Of values that fall, the position farthest below the straight line from the first to the last,
/// both axes brought to the same length; the first of equals. Expects: at least one (checked).
int Elbow(std::span<const double> values);

struct ElbowSpec {
  int least = 2;          // clusters
  int most = 60;          // and at most a tenth of the points
  int step = 2;           // between numbers that are tried
  int starts = 3;         // of each number
  double multiple = 1.0;  // of the number at the elbow that is taken, to see what hangs on it
};

/// Clusters of as many groups as the elbow of their spreads says. Fewer than 20 points are one
/// group. Source: Sharma et al., "Hierarchical Unsupervised Topological SLAM", 2023, section III-A;
/// the range of numbers is ours.
Clusters ClusterByElbow(const Eigen::MatrixXf& points, const ElbowSpec& spec, sim::Rng* rng);

}  // namespace bulletnav::agent
