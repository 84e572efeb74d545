// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_figures.h"

#include <cmath>

#include <gmock/gmock.h>

#include "benchmark/evaluate_perception/perception_report.h"
#include "tests/benchmark/evaluate_perception/fake_cases.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

constexpr int kScenes = 4;
constexpr int kPlaces = 24;

std::vector<SceneCases> Cases(void (*predict)(SceneCases*)) {
  std::vector<SceneCases> cases;
  for (int scene = 0; scene < kScenes; ++scene) {
    cases.push_back(tests::RandomCases(static_cast<std::uint64_t>(scene), kPlaces));
    predict(&cases.back());
  }
  return cases;
}

TEST(PerceptionFigures, OfAPerfectModelArePerfect) {
  const PerceptionFigures figures = MeasurePerception(Cases(tests::PredictTruth), {});
  EXPECT_EQ(figures.places, kScenes * kPlaces);
  EXPECT_EQ(figures.connection.pairs, kScenes * kPlaces * (kPlaces - 1));
  EXPECT_DOUBLE_EQ(figures.connection.average_precision, 1.0);
  EXPECT_DOUBLE_EQ(figures.connection.at.balanced_accuracy, 1.0);
  for (const ConnectionBin& bin : figures.connection.by_distance) {
    if (bin.accuracy.count == 0) continue;
    EXPECT_EQ(bin.accuracy.value, 1.0) << bin.bin;
  }
  EXPECT_DOUBLE_EQ(figures.explorable.at.f1, 1.0);
  EXPECT_DOUBLE_EQ(figures.relative_pose.all.direction_exact.value, 1.0);
  EXPECT_LE(figures.relative_pose.all.bearing_error.value, 15.0);  // half a direction
  EXPECT_NEAR(figures.relative_pose.all.distance_error.value, 0.0, 1e-3);
  EXPECT_NEAR(figures.score.error.value, 0.0, 1e-6);
  EXPECT_NEAR(figures.score.rank_in_place.value, 1.0, 1e-9);
  EXPECT_NEAR(figures.score.rank_overall, 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(figures.score.model.best.value, 1.0);
  EXPECT_NEAR(figures.score.model.extra_m.value, 0.0, 1e-6);
}

TEST(PerceptionFigures, OfAConstantModelAreThoseOfChance) {
  const PerceptionFigures figures = MeasurePerception(Cases(tests::PredictConstant), {});
  EXPECT_DOUBLE_EQ(figures.connection.average_precision, figures.connection.prevalence);
  EXPECT_DOUBLE_EQ(figures.connection.at.balanced_accuracy, 0.5);
  EXPECT_DOUBLE_EQ(figures.explorable.at.f1, figures.explorable.f1_of_yes);
  EXPECT_NEAR(figures.relative_pose.all.direction_exact.value, 1.0 / 12.0, 0.06);
  EXPECT_EQ(figures.score.rank_in_place.value, 0.0);
  EXPECT_DOUBLE_EQ(figures.score.model.best.value, figures.score.chance.best.value);
  EXPECT_DOUBLE_EQ(figures.score.model.within_1m.value, figures.score.chance.within_1m.value);
  EXPECT_DOUBLE_EQ(figures.score.model.extra_m.value, figures.score.chance.extra_m.value);
}

TEST(PerceptionFigures, ChoicesAreTheHandMadeOnes) {
  SceneCases cases = tests::RandomCases(1, 2);
  cases.samples.explorable = {0b1011, 0};  // of the first place: 0, 1 and 3
  PairLabel& pair = cases.samples.pairs[1];
  pair.same_node = 0;
  pair.score = {200, 194, 255, 50};  // 1 m is 12.75; direction 2 is none to choose
  cases.prediction(0, 1).score = {0.4f, 0.6f, 0.9f, 0.1f};
  cases.samples.reach[0] = {100, 200, 300, 290};
  const ScoreFigures figures = MeasureScores({&cases, 1}, 0);
  EXPECT_EQ(figures.model.best.count, 1);
  EXPECT_EQ(figures.model.best.value, 0.0);
  EXPECT_EQ(figures.model.within_1m.value, 1.0);
  EXPECT_NEAR(figures.model.extra_m.value, 20.0 * 6.0 / 255.0, 1e-5);
  EXPECT_NEAR(figures.chance.best.value, 1.0 / 3.0, 1e-9);
  EXPECT_NEAR(figures.chance.within_1m.value, 2.0 / 3.0, 1e-9);
  EXPECT_EQ(figures.reach.within_1m.value, 0.0);
  EXPECT_NEAR(figures.rank_in_place.value, 0.5, 1e-9);
}

TEST(PerceptionFigures, BinsOfDistanceHaveTheirLowerEnds) {
  EXPECT_EQ(DistanceBinName(DistanceBin(0.0)), "0-0.5");
  EXPECT_EQ(DistanceBinName(DistanceBin(0.5)), "0.5-1");
  EXPECT_EQ(DistanceBinName(DistanceBin(9.99)), "5-10");
  EXPECT_EQ(DistanceBinName(DistanceBin(1e9)), "10+");
}

TEST(PerceptionFigures, BinsHoldAllPairs) {
  const auto connection = MeasurePerception(Cases(tests::PredictConstant), {}).connection;
  for (const auto* bins : {&connection.by_distance, &connection.by_walls}) {
    std::int64_t pairs = 0;
    for (const ConnectionBin& bin : *bins) {
      pairs += bin.accuracy.count;
      EXPECT_EQ(bin.accuracy.count, bin.recall.count + bin.false_positive_rate.count);
    }
    EXPECT_EQ(pairs, connection.pairs);
  }
}

TEST(PerceptionReport, NamesEveryFunctionAndHasNullForWhatCannotBeSaid) {
  const auto cases = Cases(tests::PredictTruth);
  const PerceptionConfig config;
  const PerceptionFigures figures = MeasurePerception(cases, config);
  const std::string json = ToJson(figures, config, {"a.safetensors", "12", "0"});
  const std::string text = ToMarkdown(figures, config, {"a.safetensors", "12", "0"});
  for (const char* key : {"\"average_precision\": 1.0", "\"by_walls\"", "\"curve\"", "null",
                          "\"direction_within_one\"", "\"choice_by_straight_line\""}) {
    EXPECT_THAT(json, HasSubstr(key));
  }
  for (const char* head : {"## Connection", "## Explorable", "## Relative pose", "## Scores"}) {
    EXPECT_THAT(text, HasSubstr(head));
  }
}

}  // namespace
}  // namespace bulletnav::bench
