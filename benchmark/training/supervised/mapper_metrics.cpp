// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/mapper_metrics.h"

#include <cmath>

#include "agent/models/free_space_model.h"

namespace bulletnav::bench {
namespace {

using agent::FreeSpace;

constexpr std::array<double, MapperMetrics::kRings + 1> kRingEdges = {0.0, 1.0, 2.0,
                                                                      FreeSpace::kReach};

double Share(double part, double whole) {
  return whole > 0.0 ? part / whole : 0.0;
}

torch::Tensor Ring(std::size_t number) {
  const torch::Tensor mask = torch::zeros({FreeSpace::kSide, FreeSpace::kSide}, torch::kBool);
  auto cells = mask.accessor<bool, 2>();
  for (int y = 0; y < FreeSpace::kSide; ++y) {
    for (int x = 0; x < FreeSpace::kSide; ++x) {
      const FreeSpace::Place p = FreeSpace::CentreOf({x, y});
      const double range = std::hypot(p.x, p.y);
      cells[y][x] = range >= kRingEdges[number] && range < kRingEdges[number + 1];
    }
  }
  return mask;
}

/// With the eight cells around each.
torch::Tensor Grown(const torch::Tensor& cells) {
  return at::max_pool2d(cells.to(torch::kFloat32), {3, 3}, {1, 1}, {1, 1}).gt(0.5);
}

}  // namespace

double MapperSums::Counts::explored_iou() const {
  return Share(explored_both, explored_either);
}
double MapperSums::Counts::precision() const {
  return Share(told_right, told);
}
double MapperSums::Counts::recall() const {
  return Share(found, there);
}
double MapperSums::Counts::f1() const {
  return Share(2.0 * precision() * recall(), precision() + recall());
}

MapperSums::Counts& MapperSums::Counts::operator+=(const Counts& other) {
  explored_both += other.explored_both;
  explored_either += other.explored_either;
  obstacle_both += other.obstacle_both;
  obstacle_either += other.obstacle_either;
  told += other.told;
  told_right += other.told_right;
  there += other.there;
  found += other.found;
  return *this;
}

MapperSums::MapperSums() {
  for (std::size_t i = 0; i < rings_.size(); ++i) rings_[i] = Ring(i);
}

void MapperSums::Add(const torch::Tensor& answers, const torch::Tensor& labels,
                     double obstacle_weight) {
  loss_ += LossesOf(answers, labels, obstacle_weight).Total().item<double>();
  batches_ += 1.0;
  const torch::Tensor explored = answers.select(1, 0).ge(0.0);
  const torch::Tensor obstacle = answers.select(1, 1).ge(0.0).logical_and(explored);
  const torch::Tensor is_explored = labels.select(1, 0).gt(0.5);
  const torch::Tensor is_obstacle = labels.select(1, 1).gt(0.5);
  const torch::Tensor near_told = Grown(obstacle);
  const torch::Tensor near_true = Grown(is_obstacle);
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const auto count = [&](const torch::Tensor& cells) {
      return static_cast<double>(cells.logical_and(rings_[i]).sum().item<std::int64_t>());
    };
    Counts more;
    more.explored_both = count(explored.logical_and(is_explored));
    more.explored_either = count(explored.logical_or(is_explored));
    more.obstacle_both = count(obstacle.logical_and(is_obstacle));
    more.obstacle_either = count(obstacle.logical_or(is_obstacle));
    more.told = count(obstacle);
    more.told_right = count(obstacle.logical_and(near_true));
    more.there = count(is_obstacle);
    more.found = count(is_obstacle.logical_and(near_told));
    counts_[i] += more;
  }
}

MapperMetrics MapperSums::Means() const {
  MapperMetrics metrics;
  metrics.loss = Share(loss_, batches_);
  Counts all;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    metrics.ring_explored_iou[i] = counts_[i].explored_iou();
    metrics.ring_obstacle_f1[i] = counts_[i].f1();
    all += counts_[i];
  }
  metrics.explored_iou = all.explored_iou();
  metrics.obstacle_iou = Share(all.obstacle_both, all.obstacle_either);
  metrics.obstacle_precision = all.precision();
  metrics.obstacle_recall = all.recall();
  return metrics;
}

}  // namespace bulletnav::bench
