// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "benchmark/training/supervised/nts_loss.h"

namespace bulletnav::bench {

/// How well a model does. Shares of right answers about yes or no weigh both answers the same:
/// guessing gives 0.5. Directions are guessed right with 1/12.
struct NtsMetrics {
  double loss = 0.0;              // total, mean over batches
  double connection = 0.0;        // share right
  double direction = 0.0;         // share in the right twelfth
  double direction_near = 0.0;    // share in the right twelfth or a neighbour of it
  double distance_error_m = 0.0;  // mean absolute, of pairs of one node
  double explorable = 0.0;        // share right
  double score_error = 0.0;       // mean absolute
  double score_choice = 0.0;      // share of pairs whose highest score is within 1 m of the best

  template <class V>
  void Visit(V& v) {
    v("loss", loss);
    v("connection", connection);
    v("direction", direction);
    v("direction_near", direction_near);
    v("distance_error_m", distance_error_m);
    v("explorable", explorable);
    v("score_error", score_error);
    v("score_choice", score_choice);
  }
};

/// Sums over batches.
class MetricSums {
 public:
  void Add(const torch::Tensor& explorable, const agent::PairOutputs& outputs,
           const LabelledPairs& labels);
  NtsMetrics Means() const;

 private:
  struct Mean {
    double sum = 0.0;
    double count = 0.0;
    void Add(const torch::Tensor& values);
    double value() const { return count > 0.0 ? sum / count : 0.0; }
  };
  /// Of yes and of no apart.
  struct Balanced {
    std::array<Mean, 2> of;
    void Add(const torch::Tensor& logits, const torch::Tensor& truth);
    double value() const { return 0.5 * (of[0].value() + of[1].value()); }
  };

  Mean loss_;
  Balanced connection_;
  Mean direction_;
  Mean direction_near_;
  Mean distance_error_;
  Balanced explorable_;
  Mean score_error_;
  Mean score_choice_;
};

}  // namespace bulletnav::bench
