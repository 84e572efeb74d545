// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A detector's average precision among `loops` covisible pairs, and its mean error.
DetectorResult Made(const std::string& name, double precision, std::optional<double> error,
                    int loops = 5) {
  DetectorResult result;
  result.name = name;
  RankingOutcome& ranking = result.rankings["covisible"];
  ranking.figures.average_precision = precision;
  ranking.loops = loops;
  if (error) {
    result.outcome.error.emplace();
    result.outcome.error->planar.mean = *error;
  }
  return result;
}

DriveResult Driven(const std::string& scene, std::vector<DetectorResult> detectors) {
  DriveResult drive;
  drive.scene = scene;
  drive.detectors = std::move(detectors);
  return drive;
}

SlamConfig Config(const std::string& against) {
  SlamConfig config;
  config.detectors = {{"flat", "flat", {}}, {"other", "other", {}}};
  config.against = against;
  return config;
}

TEST(ComparisonTable, IsEmptyIfNothingIsToBeCompared) {
  const DriveResult drive = Driven("a", {Made("flat", 0.1, 1.0), Made("other", 0.2, 1.0)});
  EXPECT_THAT(ComparisonTable(Config(""), {&drive}), IsEmpty());
}

TEST(ComparisonTable, ScenesCountAlikeHoweverOftenTheyAreDriven) {
  // +.1 and +.3 in one scene, +.4 in the other: .3 of scenes, not .267 of drives.
  const DriveResult one = Driven("a", {Made("flat", 0.1, 1.0), Made("other", 0.2, 0.5)});
  const DriveResult two = Driven("a", {Made("flat", 0.1, 1.0), Made("other", 0.4, 0.5)});
  const DriveResult three = Driven("b", {Made("flat", 0.2, 1.0), Made("other", 0.6, 0.5)});
  const std::string table = ComparisonTable(Config("flat"), {&one, &two, &three});
  EXPECT_THAT(table, AllOf(HasSubstr("Less flat"), HasSubstr("| other | +0.300 (+0.200 to +0.400)"),
                           HasSubstr("| -0.500 (-0.500 to -0.500) |"), Not(HasSubstr("| flat |"))));
}

TEST(ComparisonTable, OnlyDrivesThatHaveTheFigureOfBothCount) {
  const DriveResult one = Driven("a", {Made("flat", 0.1, 1.0), Made("other", 0.2, 0.5)});
  const DriveResult none = Driven("b", {Made("flat", 0.0, 1.0, 0), Made("other", 0.0, 0.9, 0)});
  const DriveResult lost = Driven("c", {Made("flat", 0.1, 1.0), Made("other", 0.2, std::nullopt)});
  const std::string table = ComparisonTable(Config("flat"), {&one, &none, &lost});
  EXPECT_THAT(table, AllOf(HasSubstr("| other | +0.100 (+0.100 to +0.100)"),
                           HasSubstr("| -0.300 (-0.500 to -0.100) |")));
}

TEST(StageTable, HasWhatDetectorsWithSequencesLose) {
  DriveResult drive = Driven("a", {Made("flat", 0.4, 1.0), Made("other", 0.3, 1.0)});
  EXPECT_THAT(StageTable(Config("flat"), {&drive}), IsEmpty());
  drive.detectors[1].stages = StageOutcome{0.1, 0.8, 0.5, 0.6};
  EXPECT_THAT(StageTable(Config("flat"), {&drive}),
              HasSubstr("| other | 0.400 | 0.300 | 0.100 | 0.800 | 0.500 | 0.600 |"));
  EXPECT_THAT(StageTable(Config(""), {&drive}), IsEmpty());
}

}  // namespace
}  // namespace bulletnav::bench
