// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/yes_no_figures.h"

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

/// Three found, one missed, one false alarm, five rightly refused.
std::vector<Answer> Answers() {
  std::vector<Answer> answers = {
      {0.9f, true}, {0.8f, true}, {0.5f, true}, {0.4f, true}, {0.7f, false}};
  answers.resize(10, {0.1f, false});
  return answers;
}

TEST(YesNoFigures, AreThoseOfAHandMadeTable) {
  const YesNoFigures figures = JudgeAnswers(Answers(), 0.5);
  EXPECT_DOUBLE_EQ(figures.precision, 0.75);
  EXPECT_DOUBLE_EQ(figures.recall, 0.75);
  EXPECT_DOUBLE_EQ(figures.f1, 0.75);
  EXPECT_DOUBLE_EQ(figures.false_positive_rate, 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(figures.accuracy, 0.8);
  EXPECT_DOUBLE_EQ(figures.balanced_accuracy, 0.5 * (0.75 + 5.0 / 6.0));
}

TEST(YesNoFigures, NobodyToFindIsNoDivisionByZero) {
  const YesNoFigures none = JudgeAnswers({}, 0.5);
  EXPECT_EQ(none.precision, 1.0);
  EXPECT_EQ(none.recall, 0.0);
  EXPECT_EQ(none.f1, 0.0);
}

TEST(YesNoFigures, HigherThresholdsFindLess) {
  const auto rows = JudgeAtThresholds(Answers());
  ASSERT_EQ(rows.size(), kThresholds.size());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_GT(rows[i].threshold, rows[i - 1].threshold);
    EXPECT_LE(rows[i].recall, rows[i - 1].recall);
    EXPECT_LE(rows[i].false_positive_rate, rows[i - 1].false_positive_rate);
  }
}

}  // namespace
}  // namespace bulletnav::bench
