// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/yes_no_figures.h"

namespace bulletnav::bench {
namespace {

/// 0 where nothing was counted, unless told.
double Share(int part, int whole, double of_none = 0.0) {
  return whole > 0 ? static_cast<double>(part) / whole : of_none;
}

}  // namespace

YesNoFigures JudgeAnswers(std::span<const Answer> answers, double threshold) {
  std::array<std::array<int, 2>, 2> count{};  // [what is true][what was said]
  for (const Answer& answer : answers) {
    const bool says = double{answer.score} >= threshold;
    ++count[answer.is_true ? 1 : 0][says ? 1 : 0];
  }
  const int yes = count[1][0] + count[1][1];
  const int no = count[0][0] + count[0][1];
  YesNoFigures figures;
  figures.threshold = threshold;
  figures.precision = Share(count[1][1], count[0][1] + count[1][1], 1.0);
  figures.recall = Share(count[1][1], yes);
  figures.false_positive_rate = Share(count[0][1], no);
  figures.f1 = Share(2 * count[1][1], 2 * count[1][1] + count[0][1] + count[1][0]);
  figures.accuracy = Share(count[0][0] + count[1][1], yes + no);
  figures.balanced_accuracy = 0.5 * (figures.recall + 1.0 - figures.false_positive_rate);
  return figures;
}

std::vector<YesNoFigures> JudgeAtThresholds(std::span<const Answer> answers) {
  std::vector<YesNoFigures> figures;
  figures.reserve(kThresholds.size());
  for (const double threshold : kThresholds) figures.push_back(JudgeAnswers(answers, threshold));
  return figures;
}

}  // namespace bulletnav::bench
