// SPDX-License-Identifier: MIT
#include "agent/nts/settle_graph.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "sim/base/check.h"
#include "sim/base/elementary.h"

namespace bulletnav::agent {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
constexpr double kStay = 1e-9;     // keeps the matrix definite where an edge says next to nothing
constexpr double kSettled = 1e-6;  // metres and radians: less is no change

/// How an edge's error changes with its two poses.
struct Linear {
  Eigen::Vector3d error;
  Eigen::Matrix3d by_from;
  Eigen::Matrix3d by_to;
};

/// Error: the pose of `to` seen from where it was measured.
Linear LinearOf(const sim::PlanarPose& from, const sim::PlanarPose& to,
                const sim::PlanarPose& measured) {
  const double c = sim::Cos(from.yaw);
  const double s = sim::Sin(from.yaw);
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double x = c * dx + s * dy;
  const double y = c * dy - s * dx;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn(0, 0) = turn(1, 1) = sim::Cos(measured.yaw);
  turn(0, 1) = sim::Sin(measured.yaw);
  turn(1, 0) = -turn(0, 1);
  Linear linear;
  linear.error = turn * Eigen::Vector3d(x - measured.x, y - measured.y, 0.0);
  linear.error[2] = sim::WrapAngle(to.yaw - from.yaw - measured.yaw);
  linear.by_from << -c, -s, y, s, -c, -x, 0.0, 0.0, -1.0;
  linear.by_to << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
  linear.by_from = turn * linear.by_from;
  linear.by_to = turn * linear.by_to;
  return linear;
}

/// The equations of one round; the fixed vertex has none.
class Equations {
 public:
  explicit Equations(std::size_t size) : right_(Eigen::VectorXd::Zero(3 * Eigen::Index(size))) {}

  void Add(const Linear& linear, const Eigen::Matrix3d& information, int from, int to) {
    const std::array<int, 2> ends = {from, to};
    const std::array<const Eigen::Matrix3d*, 2> by = {&linear.by_from, &linear.by_to};
    for (std::size_t i = 0; i < 2; ++i) {
      if (ends[i] < 0) continue;
      right_.segment<3>(3 * Eigen::Index(ends[i])) -=
          by[i]->transpose() * information * linear.error;
      for (std::size_t k = 0; k < 2; ++k) {
        if (ends[k] >= 0) AddBlock(ends[i], ends[k], by[i]->transpose() * information * *by[k]);
      }
    }
  }

  Eigen::VectorXd Solve() {
    for (int i = 0; i < static_cast<int>(right_.size()); ++i) entries_.emplace_back(i, i, kStay);
    Sparse matrix(right_.size(), right_.size());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Sparse> solver(matrix);
    BULLETNAV_CHECK(solver.info() == Eigen::Success);
    return solver.solve(right_);
  }

 private:
  void AddBlock(int row, int col, const Eigen::Matrix3d& block) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) entries_.emplace_back(3 * row + r, 3 * col + c, block(r, c));
    }
  }

  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_;
};

}  // namespace

void SettleGraph(const SettleOptions& options, PlanarPoseGraph* graph) {
  auto& vertices = graph->vertices;
  std::vector<int> number(vertices.size(), -1);
  int free = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!vertices[i].is_fixed) number[i] = free++;
  }
  BULLETNAV_CHECK(static_cast<std::size_t>(free) + 1 == vertices.size());
  for (const PoseEdge<sim::PlanarPose>& edge : graph->edges) {
    const auto size = static_cast<std::int64_t>(vertices.size());
    BULLETNAV_CHECK(edge.from >= 0 && edge.from < size && edge.to >= 0 && edge.to < size);
  }
  const double width = options.kernel_width * options.kernel_width;
  for (int round = 0; free > 0 && round < options.rounds; ++round) {
    Equations equations(static_cast<std::size_t>(free));
    for (const PoseEdge<sim::PlanarPose>& edge : graph->edges) {
      const auto from = static_cast<std::size_t>(edge.from);
      const auto to = static_cast<std::size_t>(edge.to);
      const Linear linear = LinearOf(vertices[from].pose, vertices[to].pose, edge.measured);
      const double square = linear.error.dot(edge.information * linear.error);
      const double weight = edge.is_loop ? 1.0 / (1.0 + square / width) : 1.0;
      equations.Add(linear, weight * edge.information, number[from], number[to]);
    }
    const Eigen::VectorXd change = equations.Solve();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (number[i] < 0) continue;
      const auto by = change.segment<3>(3 * Eigen::Index(number[i]));
      sim::PlanarPose& pose = vertices[i].pose;
      pose = {pose.x + by[0], pose.y + by[1], sim::WrapAngle(pose.yaw + by[2])};
    }
    if (change.cwiseAbs().maxCoeff() < kSettled) return;
  }
}

}  // namespace bulletnav::agent
