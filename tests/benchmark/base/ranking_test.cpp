// SPDX-License-Identifier: MIT
#include "benchmark/base/ranking.h"

#include <gmock/gmock.h>

namespace bulletnav::bench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

double ApOf(std::vector<Answer> answers) {
  return AveragePrecision(PrecisionRecallCurve(std::move(answers)));
}

TEST(AveragePrecision, IsThatOfHandMadeRankings) {
  // Right answers on places 1 and 3: (1/1 + 2/3) / 2.
  EXPECT_DOUBLE_EQ(ApOf({{0.9f, true}, {0.8f, false}, {0.7f, true}, {0.1f, false}}), 5.0 / 6.0);
  EXPECT_DOUBLE_EQ(ApOf({{0.1f, true}, {0.8f, false}, {0.7f, false}}), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(ApOf({{0.2f, false}, {0.8f, true}, {0.7f, true}}), 1.0);
}

TEST(AveragePrecision, OfEqualScoresIsTheShareOfYes) {
  EXPECT_DOUBLE_EQ(ApOf({{0.5f, true}, {0.5f, false}, {0.5f, false}, {0.5f, false}}), 0.25);
}

TEST(AveragePrecision, IsZeroIfYesIsNeverRight) {
  EXPECT_THAT(PrecisionRecallCurve({{0.5f, false}}), IsEmpty());
  EXPECT_DOUBLE_EQ(ApOf({{0.5f, false}}), 0.0);
  EXPECT_DOUBLE_EQ(ApOf({}), 0.0);
}

TEST(PrecisionRecallCurve, EndsWithEverythingFound) {
  const auto curve = PrecisionRecallCurve({{0.9f, true}, {0.8f, false}, {0.8f, true}});
  ASSERT_EQ(curve.size(), 2u);
  EXPECT_DOUBLE_EQ(curve[0].recall, 0.5);
  EXPECT_DOUBLE_EQ(curve[0].precision, 1.0);
  EXPECT_DOUBLE_EQ(curve[1].recall, 1.0);
  EXPECT_DOUBLE_EQ(curve[1].precision, 2.0 / 3.0);
}

TEST(PrecisionRecallCurve, ThinsToStepsOfRecall) {
  std::vector<Answer> answers;
  for (int i = 0; i < 1000; ++i) answers.push_back({static_cast<float>(-i), i % 2 == 0});
  const auto thin = Thin(PrecisionRecallCurve(answers), 10);
  ASSERT_EQ(thin.size(), 11u);
  for (std::size_t i = 1; i < thin.size(); ++i) {
    EXPECT_NEAR(thin[i].recall, 0.1 * static_cast<double>(i), 0.002);
  }
}

TEST(Ranks, AreSharedByEqualValues) {
  EXPECT_THAT(Ranks(std::vector{3.0, 1.0, 3.0, 2.0}), ElementsAre(3.5, 1.0, 3.5, 2.0));
}

TEST(RankCorrelation, KnowsOrderAlone) {
  const std::vector<double> a = {1.0, 2.0, 3.0, 4.0};
  EXPECT_DOUBLE_EQ(RankCorrelation(a, std::vector{-9.0, 0.0, 0.1, 100.0}), 1.0);
  EXPECT_DOUBLE_EQ(RankCorrelation(a, std::vector{4.0, 3.0, 2.0, 1.0}), -1.0);
  // 1 - 6 sum d^2 / (n (n^2 - 1)), d = 0, 1, -1, 0
  EXPECT_DOUBLE_EQ(RankCorrelation(a, std::vector{1.0, 3.0, 2.0, 4.0}), 0.8);
}

TEST(RankCorrelation, IsZeroForConstants) {
  EXPECT_EQ(RankCorrelation(std::vector{1.0, 2.0}, std::vector{5.0, 5.0}), 0.0);
  EXPECT_EQ(RankCorrelation(std::vector<double>{}, std::vector<double>{}), 0.0);
}

}  // namespace
}  // namespace bulletnav::bench
