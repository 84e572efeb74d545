// SPDX-License-Identifier: MIT
#include "agent/slam/topology/clusters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

constexpr int kMostRounds = 100;
constexpr int kPointsACluster = 10;

/// The first centre at random, each other with a chance that grows with its squared distance.
Eigen::MatrixXf Seeds(const Eigen::MatrixXf& points, int k, sim::Rng* rng) {
  const auto count = static_cast<int>(points.rows());
  Eigen::MatrixXf centres(k, points.cols());
  centres.row(0) = points.row(rng->Below(count));
  Eigen::VectorXf nearest = (points.rowwise() - centres.row(0)).rowwise().squaredNorm();
  for (int i = 1; i < k; ++i) {
    const std::vector<double> weights(nearest.data(), nearest.data() + nearest.size());
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    // All points are centres already: any will do.
    const int drawn = sum > 0.0 ? static_cast<int>(rng->Weighted(weights)) : rng->Below(count);
    centres.row(i) = points.row(drawn);
    nearest = nearest.cwiseMin((points.rowwise() - centres.row(i)).rowwise().squaredNorm().eval());
  }
  return centres;
}

/// Gives each point to the nearest centre, the first of equals; whether anything changed.
bool Assign(const Eigen::MatrixXf& points, Clusters* clusters) {
  const Eigen::VectorXf lengths = clusters->centres.rowwise().squaredNorm();
  const Eigen::MatrixXf products = points * clusters->centres.transpose();
  bool is_changed = false;
  clusters->spread = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::Index best = 0;
    const float least = (lengths.transpose() - 2.0f * products.row(i)).minCoeff(&best);
    int& group = clusters->group[static_cast<std::size_t>(i)];
    is_changed |= group != static_cast<int>(best);
    group = static_cast<int>(best);
    clusters->spread += std::max(0.0f, least + points.row(i).squaredNorm());
  }
  return is_changed;
}

void MoveToMeans(const Eigen::MatrixXf& points, Clusters* clusters) {
  Eigen::MatrixXf sums = Eigen::MatrixXf::Zero(clusters->centres.rows(), points.cols());
  std::vector<int> counts(static_cast<std::size_t>(sums.rows()), 0);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const int group = clusters->group[static_cast<std::size_t>(i)];
    sums.row(group) += points.row(i);
    ++counts[static_cast<std::size_t>(group)];
  }
  for (Eigen::Index group = 0; group < sums.rows(); ++group) {
    const int count = counts[static_cast<std::size_t>(group)];
    if (count > 0) clusters->centres.row(group) = sums.row(group) / static_cast<float>(count);
  }
}

}  // namespace

Clusters ClusterPoints(const Eigen::MatrixXf& points, int k, int starts, sim::Rng* rng) {
  BULLETNAV_CHECK(k >= 1 && k <= points.rows() && starts >= 1);
  Clusters best;
  for (int start = 0; start < starts; ++start) {
    Clusters clusters;
    clusters.centres = Seeds(points, k, rng);
    clusters.group.assign(static_cast<std::size_t>(points.rows()), -1);
    for (int round = 0; round < kMostRounds && Assign(points, &clusters); ++round) {
      MoveToMeans(points, &clusters);
    }
    if (start == 0 || clusters.spread < best.spread) best = std::move(clusters);
  }
  return best;
}

int Elbow(std::span<const double> values) {
  BULLETNAV_CHECK(!values.empty());
  const double fall = values.front() - values.back();
  if (values.size() < 3 || !(fall > 0.0)) return 0;
  int best = 0;
  double farthest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(values.size() - 1);
    const double below = 1.0 - along - (values[i] - values.back()) / fall;
    if (below > farthest) {
      farthest = below;
      best = static_cast<int>(i);
    }
  }
  return best;
}

Clusters ClusterByElbow(const Eigen::MatrixXf& points, const ElbowSpec& spec, sim::Rng* rng) {
  const auto count = static_cast<int>(points.rows());
  const int most = std::min(spec.most, count / kPointsACluster);
  if (most < spec.least) return ClusterPoints(points, 1, 1, rng);
  std::vector<Clusters> all;
  std::vector<int> tried;
  std::vector<double> spreads;
  for (int k = spec.least; k <= most; k += spec.step) {
    all.push_back(ClusterPoints(points, k, spec.starts, rng));
    tried.push_back(k);
    spreads.push_back(all.back().spread);
  }
  const auto elbow = static_cast<std::size_t>(Elbow(spreads));
  const int wanted =
      std::clamp(static_cast<int>(std::lround(spec.multiple * tried[elbow])), 1, count);
  Clusters best = wanted == tried[elbow] ? std::move(all[elbow])
                                         : ClusterPoints(points, wanted, spec.starts, rng);
  best.tried = std::move(tried);
  best.spreads = std::move(spreads);
  return best;
}

}  // namespace bulletnav::agent
