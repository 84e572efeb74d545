// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "benchmark/base/ranking.h"

namespace bulletnav::bench {

/// Answers of yes or no from one threshold on.
struct YesNoFigures {
  double threshold = 0.0;
  double precision = 0.0;  // share right of those answered yes; 1 if there are none
  double recall = 0.0;     // share found of those that are
  double false_positive_rate = 0.0;
  double f1 = 0.0;
  double accuracy = 0.0;
  double balanced_accuracy = 0.0;  // mean of recall and 1 - false_positive_rate

  template <class V>
  void Visit(V& v) {
    v("threshold", threshold);
    v("precision", precision);
    v("recall", recall);
    v("false_positive_rate", false_positive_rate);
    v("f1", f1);
    v("accuracy", accuracy);
    v("balanced_accuracy", balanced_accuracy);
  }
};
YesNoFigures JudgeAnswers(std::span<const Answer> answers, double threshold);

/// Thresholds that agents may be given.
inline constexpr std::array kThresholds = {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99};
std::vector<YesNoFigures> JudgeAtThresholds(std::span<const Answer> answers);

}  // namespace bulletnav::bench
