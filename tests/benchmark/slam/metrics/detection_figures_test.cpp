// SPDX-License-Identifier: MIT
#include "benchmark/slam/metrics/detection_figures.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(MeasureDetection, IsThatOfACountedExample) {
  // Right, right, wrong, right; one loop of four is never named.
  const std::vector<Answer> answers = {{0.9f, true}, {0.8f, true}, {0.7f, false}, {0.6f, true}};
  const DetectionFigures figures = MeasureDetection(answers, {4, 40});
  EXPECT_DOUBLE_EQ(figures.average_precision, 0.25 + 0.25 + 0.25 * 0.75);
  EXPECT_DOUBLE_EQ(figures.recall_at_1, 0.5);
  EXPECT_DOUBLE_EQ(figures.recall_at_099, 0.5);
  EXPECT_DOUBLE_EQ(figures.guessing, 0.1);
}

/// What accepting from a threshold on gives, counted anew for each.
struct Tally {
  double recall = 0.0;
  double precision = 0.0;
};
Tally CountFrom(double threshold, const std::vector<Answer>& answers, double true_pairs) {
  double right = 0.0;
  double accepted = 0.0;
  for (const Answer& answer : answers) {
    if (answer.score < threshold) continue;
    accepted += 1.0;
    right += answer.is_true ? 1.0 : 0.0;
  }
  return {right / true_pairs, right / accepted};
}

TEST(MeasureDetection, AgreesWithCountingAtEveryThreshold) {
  sim::Rng rng(1, "answers");
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Answer> answers;
    double found = 0.0;
    for (int i = 0; i < 300; ++i) {
      const bool is_true = rng.Chance(0.4);
      found += is_true ? 1.0 : 0.0;
      // Ties too.
      const double score = std::floor(40.0 * (rng.Uniform() + (is_true ? 0.6 : 0.0)));
      answers.push_back({static_cast<float>(score), is_true});
    }
    const double true_pairs = found + 25.0;
    double area = 0.0;
    double last = 0.0;
    double at_1 = 0.0;
    double at_099 = 0.0;
    double at_09 = 0.0;
    for (int threshold = 64; threshold >= 0; --threshold) {
      if (answers.end() == std::find_if(answers.begin(), answers.end(), [&](const Answer& a) {
            return a.score >= static_cast<float>(threshold);
          })) {
        continue;
      }
      const Tally counted = CountFrom(threshold, answers, true_pairs);
      area += (counted.recall - last) * counted.precision;
      last = counted.recall;
      if (counted.precision >= 1.0) at_1 = std::max(at_1, counted.recall);
      if (counted.precision >= 0.99) at_099 = std::max(at_099, counted.recall);
      if (counted.precision >= 0.9) at_09 = std::max(at_09, counted.recall);
    }
    const DetectionFigures figures =
        MeasureDetection(answers, {static_cast<std::int64_t>(true_pairs), 1000});
    EXPECT_NEAR(figures.average_precision, area, 1e-12);
    EXPECT_NEAR(figures.recall_at_1, at_1, 1e-12);
    EXPECT_NEAR(figures.recall_at_099, at_099, 1e-12);
    EXPECT_NEAR(figures.recall_at_09, at_09, 1e-12);
  }
}

TEST(MeasureDetection, NothingNamedIsNothingFound) {
  const DetectionFigures figures = MeasureDetection({}, {3, 10});
  EXPECT_EQ(figures.average_precision, 0.0);
  EXPECT_EQ(figures.recall_at_1, 0.0);
  EXPECT_DOUBLE_EQ(figures.guessing, 0.3);
}

TEST(MeasureDetection, TellsCountsThatDoNotFit) {
  EXPECT_THAT(
      [] {
        MeasureDetection({{0.5f, true}, {0.4f, true}}, {1, 10});
      },
      ThrowsMessage<sim::Error>(HasSubstr("2 loops were found of 1 there are")));
}

TEST(RecallAt, CountsQueriesWithARightOneAmongTheFirst) {
  const std::vector<RankedTruth> queries = {{true, false}, {false, false, true}, {false, true}, {}};
  EXPECT_DOUBLE_EQ(RecallAt(queries, 1), 0.25);
  EXPECT_DOUBLE_EQ(RecallAt(queries, 2), 0.5);
  EXPECT_DOUBLE_EQ(RecallAt(queries, 5), 0.75);
  EXPECT_THAT(
      [&] {
        RecallAt(queries, 0);
      },
      ThrowsMessage<sim::Error>(HasSubstr("at least 1")));
  EXPECT_THAT(
      [&] {
        RecallAt({}, 1);
      },
      ThrowsMessage<sim::Error>(HasSubstr("a query")));
}

}  // namespace
}  // namespace bulletnav::bench
