// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "agent/perception/torch.h"
#include "benchmark/training/supervised/mapper_loss.h"

namespace bulletnav::bench {

/// How well a mapper does, counting probabilities from 0.5 on as yes, and obstacles only where they
/// are explored too, as agents do. Rings: to 1 m, from there to 2 m, from there to 3.2 m.
struct MapperMetrics {
  static constexpr int kRings = 3;

  double loss = 0.0;                // total, mean over batches
  double explored_iou = 0.0;        // intersection over union, over all cells in reach
  double obstacle_iou = 0.0;        // likewise, to the cell: walls are one cell thick
  double obstacle_precision = 0.0;  // share of obstacles with a true one on or beside their cell
  double obstacle_recall = 0.0;     // share of true obstacles that are found so
  std::array<double, kRings> ring_explored_iou = {};
  std::array<double, kRings> ring_obstacle_f1 = {};  // of precision and recall as above

  template <class V>
  void Visit(V& v) {
    v("loss", loss);
    v("explored_iou", explored_iou);
    v("obstacle_iou", obstacle_iou);
    v("obstacle_precision", obstacle_precision);
    v("obstacle_recall", obstacle_recall);
    v("explored_iou_1m", ring_explored_iou[0]);
    v("explored_iou_2m", ring_explored_iou[1]);
    v("explored_iou_3m", ring_explored_iou[2]);
    v("obstacle_f1_1m", ring_obstacle_f1[0]);
    v("obstacle_f1_2m", ring_obstacle_f1[1]);
    v("obstacle_f1_3m", ring_obstacle_f1[2]);
  }
};

/// Sums over batches.
class MapperSums {
 public:
  MapperSums();

  /// Of net answers, logits, and labels as FreeSpaceLabels gives them.
  void Add(const torch::Tensor& answers, const torch::Tensor& labels, double obstacle_weight);
  MapperMetrics Means() const;

 private:
  /// Cells of one ring.
  struct Counts {
    double explored_both = 0.0;
    double explored_either = 0.0;
    double obstacle_both = 0.0;
    double obstacle_either = 0.0;
    double told = 0.0;        // obstacles
    double told_right = 0.0;  // of them, with a true one on or beside their cell
    double there = 0.0;       // true obstacles
    double found = 0.0;       // of them, with one that was told

    double explored_iou() const;
    double precision() const;
    double recall() const;
    double f1() const;
    Counts& operator+=(const Counts& other);
  };

  double loss_ = 0.0;
  double batches_ = 0.0;
  std::array<torch::Tensor, MapperMetrics::kRings> rings_;  // [128, 128] of bool
  std::array<Counts, MapperMetrics::kRings> counts_;
};

}  // namespace bulletnav::bench
