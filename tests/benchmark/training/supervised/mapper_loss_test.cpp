// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/mapper_loss.h"

#include <cmath>

#include <gtest/gtest.h>

#include "benchmark/training/supervised/mapper_metrics.h"

namespace bulletnav::bench {
namespace {

constexpr int kSide = agent::FreeSpace::kSide;

double Entropy(double logit, bool yes) {
  return std::log1p(std::exp(yes ? -logit : logit));
}

/// Everything explored, a wall two cells thick in the rows from `row` on, 1 m wide.
torch::Tensor Wall(int row) {
  torch::Tensor labels = torch::zeros({1, 2, kSide, kSide});
  labels.select(1, 0).fill_(1.0);
  labels.select(1, 1).narrow(1, row, 2).narrow(2, 54, 20).fill_(1.0);
  return labels;
}

/// What a net answers that is sure of `labels`.
torch::Tensor Sure(const torch::Tensor& labels) {
  return (labels - 0.5) * 20.0;
}

TEST(MapperLosses, AreEntropiesOfTheCellsThatCount) {
  torch::Tensor labels = Wall(70);
  labels.select(1, 0).narrow(1, 0, 64).fill_(0.0);
  torch::Tensor answers = torch::empty({1, 2, kSide, kSide});
  answers.select(1, 0).fill_(0.7);
  answers.select(1, 1).fill_(-0.4);
  const MapperLosses losses = LossesOf(answers, labels, 3.0);
  EXPECT_NEAR(losses.explored.item<double>(), 0.5 * (Entropy(0.7, true) + Entropy(0.7, false)),
              1e-5);
  const double explored = CellsInReach().sum().item<double>() / 2;
  EXPECT_NEAR(losses.obstacle.item<double>() * explored,
              40 * 3.0 * Entropy(-0.4, true) + (explored - 40) * Entropy(-0.4, false), 0.5);
}

TEST(MapperLosses, DoNotAskForObstaclesThatCannotBeSeen) {
  torch::Tensor labels = Wall(70);
  labels.select(1, 0).narrow(1, 80, 40).fill_(0.0);
  torch::Tensor answers = Sure(labels);
  const double before = LossesOf(answers, labels, 3.0).Total().item<double>();
  answers.select(1, 1).narrow(1, 80, 40).fill_(50.0);
  EXPECT_EQ(LossesOf(answers, labels, 3.0).Total().item<double>(), before);
  // Nor for what is out of reach.
  answers.select(2, 0).select(2, 0).fill_(1e6);
  EXPECT_EQ(LossesOf(answers, labels, 3.0).Total().item<double>(), before);
}

MapperMetrics MetricsOf(const torch::Tensor& answers, const torch::Tensor& labels) {
  MapperSums sums;
  sums.Add(answers, labels, 3.0);
  return sums.Means();
}

TEST(MapperMetrics, ArePerfectForThePerfect) {
  const MapperMetrics m = MetricsOf(Sure(Wall(70)), Wall(70));
  EXPECT_LT(m.loss, 1e-3);
  EXPECT_EQ(m.explored_iou, 1.0);
  EXPECT_EQ(m.obstacle_iou, 1.0);
  EXPECT_EQ(m.obstacle_precision, 1.0);
  EXPECT_EQ(m.obstacle_recall, 1.0);
  EXPECT_EQ(m.ring_obstacle_f1[0], 1.0);
  EXPECT_EQ(m.ring_obstacle_f1[2], 0.0) << "there are none";
}

TEST(MapperMetrics, ForgiveACellAndNoMore) {
  const MapperMetrics beside = MetricsOf(Sure(Wall(71)), Wall(70));
  EXPECT_NEAR(beside.obstacle_iou, 1.0 / 3.0, 1e-9);
  EXPECT_EQ(beside.obstacle_precision, 1.0);
  EXPECT_EQ(beside.obstacle_recall, 1.0);
  const MapperMetrics off = MetricsOf(Sure(Wall(72)), Wall(70));
  EXPECT_EQ(off.obstacle_iou, 0.0);
  EXPECT_EQ(off.obstacle_precision, 0.5);
  EXPECT_EQ(off.obstacle_recall, 0.5);
}

TEST(MapperMetrics, ObstaclesCountOnlyWhereTheyAreExplored) {
  torch::Tensor answers = Sure(Wall(70));
  answers.select(1, 0).narrow(1, 64, 64).fill_(-10.0);
  const MapperMetrics m = MetricsOf(answers, Wall(70));
  EXPECT_NEAR(m.explored_iou, 0.5, 1e-9);
  EXPECT_EQ(m.obstacle_recall, 0.0);
  EXPECT_EQ(m.obstacle_precision, 0.0);
}

}  // namespace
}  // namespace bulletnav::bench
