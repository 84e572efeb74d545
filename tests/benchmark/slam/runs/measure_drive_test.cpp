// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/measure_drive.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace bulletnav::bench
