// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/measure_drive.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "benchmark/slam/runs/slam_summary.h"
#include "benchmark/slam/runs/slam_table.h"

namespace bulletnav::bench {
namespace {

/// Cameras 3 m before one of four walls far apart, each twice: frames 4 to 7 come back to 0 to 3.
std::vector<TruthFrame> FourWallsTwice() {
  const DepthThumbnail wall = Coarsened({320, 240, std::vector<float>(76800, 3.0f)},
                                        Intrinsics{160.0, 160.0, 159.5, 119.5});
  std::vector<TruthFrame> frames;
  frames.reserve(8);
  for (int i = 0; i < 8; ++i) {
    frames.push_back({sim::Apply({}, {0.0, 30.0 * (i % 4), 0.0}), wall, i < 4 ? 0 : 4});
  }
  return frames;
}

/// Frame 4's loop is first among what it names, frame 5's third, frame 6's sixth, frame 7 names
/// others alone.
std::vector<agent::LoopCandidate> Named() {
  std::vector<agent::LoopCandidate> named;
  const auto name = [&named](int later, std::initializer_list<int> earlier) {
    double score = 1.0;
    for (const int frame : earlier) named.push_back({later, frame, score -= 0.1, false});
  };
  name(4, {0, 1, 2, 3});
  name(5, {0, 2, 1, 3});
  name(6, {0, 1, 3, 0, 1, 2});
  name(7, {0, 1, 2});
  return named;
}

TEST(MeasureRanking, CountsFramesWhoseSurestPairsHoldALoop) {
  const LoopTruth truth(FourWallsTwice(), {});
  ASSERT_EQ(truth.Count(LoopKind::kCovisible), 4);
  DetectorResult result;
  MeasureRanking(Named(), truth, false, &result);
  EXPECT_EQ(result.recall_at_1, 0.25);
  EXPECT_EQ(result.recall_at_5, 0.5);
  EXPECT_EQ(result.recall_at_10, 0.75);
}

TEST(MeasureRanking, WithoutLoopsThereIsNoRecall) {
  std::vector<TruthFrame> frames = FourWallsTwice();
  frames.resize(4);
  DetectorResult result;
  MeasureRanking({}, LoopTruth(frames, {}), false, &result);
  EXPECT_FALSE(result.recall_at_1);
  EXPECT_FALSE(result.recall_at_10);
}

/// Means are over drives that have the figure, as those of earlier versions have only the last.
TEST(SlamTables, MeansOfRecallAreOverDrivesThatHaveIt) {
  SlamConfig config;
  config.detectors.push_back({});
  config.detectors.front().name = "mine";
  config.actions = {10};
  std::vector<DriveResult> results(3);
  for (DriveResult& result : results) {
    result.actions = 10;
    result.odometry.emplace();
    DetectorResult& detector = result.detectors.emplace_back();
    detector.rankings[std::string(NameOf(LoopKind::kCovisible))].loops = 1;
    detector.recall_at_10 = 0.5;
  }
  results[0].detectors[0].recall_at_1 = 0.25;
  results[1].detectors[0].recall_at_10 = 0.8;
  const std::string text = SlamTables(config, results);
  EXPECT_NE(text.find("| mine | 0.250 |  | 0.600 |"), std::string::npos) << text;
}

TEST(SlamTables, ErrorsAreMeansOverDrivesOfOneLength) {
  SlamConfig config;
  config.detectors.push_back({});
  config.detectors.front().name = "mine";
  config.actions = {10, 20};
  std::vector<DriveResult> results(3);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const double off = static_cast<double>(i);
    results[i].actions = i < 2 ? 10 : 20;
    results[i].odometry.emplace();
    results[i].odometry->start = {0.0, 1.0 + off, 4.0, 2.0 + off};
    results[i].odometry->planar = {0.0, 0.5, 1.0, 0.75};
    DetectorResult& detector = results[i].detectors.emplace_back();
    detector.outcome.accepted = 3;
    detector.outcome.wrong = 1;
    // The second drive has no trajectory, and the third is worse than odometry.
    if (i != 1) detector.outcome.error = BothErrors{{0.0, 0.5, 1.0, 0.6}, {0.0, off, 1.0, 0.4}};
  }
  results.emplace_back().actions = 10;  // nothing is known of it
  const std::string text = SlamTables(config, results);
  for (const char* line :
       {"| odometry alone | 0.000 | 1.500 | 4.000 | 2.500 | 0.500 | 0.750 |  |  |  |",
        "| mine | 0.000 | 0.500 | 1.000 | 0.600 | 0.000 | 0.400 | 6 | 2 | 0 |",
        "| odometry alone | 0.000 | 3.000 | 4.000 | 4.000 | 0.500 | 0.750 |  |  |  |",
        "| mine | 0.000 | 0.500 | 1.000 | 0.600 | 2.000 | 0.400 | 3 | 1 | 1 |"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  }
  const std::string json = ToJson(Summarise(config, results));
  const auto read = nlohmann::json::parse(json);
  EXPECT_EQ(read["drives"], 4);
  EXPECT_EQ(read["without_truth"], 1);
  EXPECT_EQ(read["odometry"]["10"]["error"]["start"]["rmse"], 2.5);
  EXPECT_EQ(read["detectors"][0]["trajectories"]["10"]["drives"], 1);
  EXPECT_EQ(read["detectors"][0]["trajectories"]["20"]["made_worse"], 1);
  EXPECT_TRUE(read["detectors"][0]["recall_at_1"].is_null());
}

TEST(SlamTables, TimesAreMeansOverDrivesThatHaveThem) {
  SlamConfig config;
  config.detectors.push_back({});
  config.detectors.front().name = "mine";
  EXPECT_EQ(SlamTimesTable(config, std::vector<TimesByStage>(2)), "");
  const std::vector<TimesByStage> times = {
      {{"mine", {1.0, 2.0}}, {"corners", {0.5, 0.5}}}, {}, {{"mine", {3.0, 5.0}}}};
  const std::string text = SlamTimesTable(config, times);
  EXPECT_NE(text.find("| corners | 0.500 | 0.500 |\n| mine | 2.000 | 3.500 |\n"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace bulletnav::bench
