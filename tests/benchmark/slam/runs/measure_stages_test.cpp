// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/measure_stages.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

using agent::LoopCandidate;
using agent::SequenceTrace;

constexpr int kFrames = 9;  // three at a place, three 10 m away, three at the first again

/// A picture of 320 x 240 of a wall 3 m ahead.
DepthThumbnail Wall() {
  return Coarsened({320, 240, std::vector<float>(320 * 240, 3.0f)},
                   Intrinsics{160.0, 160.0, 159.5, 119.5});
}

class Stages : public ::testing::Test {
 protected:
  Stages() : truth_(Frames(), nullptr) {}

  static bool IsFirstPlace(int frame) { return frame < 3 || frame >= 6; }

  static std::vector<sim::BodyPose> Poses() {
    std::vector<sim::BodyPose> poses;
    for (int i = 0; i < kFrames; ++i) {
      poses.push_back(sim::Apply({}, {IsFirstPlace(i) ? 0.0 : 10.0, 0.0, 0.0}));
    }
    return poses;
  }

  /// Each is compared with those three and more before it.
  static std::vector<TruthFrame> Frames() {
    std::vector<TruthFrame> frames;
    for (const sim::BodyPose& pose : Poses()) {
      frames.push_back({pose, Wall(), std::max(0, static_cast<int>(frames.size()) - 2)});
    }
    return frames;
  }

  /// All pairs; the two places look more alike than each to itself.
  std::vector<LoopCandidate> Misled() const {
    std::vector<LoopCandidate> pairs;
    for (int later = 0; later < kFrames; ++later) {
      for (int earlier = 0; earlier < truth_.compared(later); ++earlier) {
        const bool is_loop = truth_.Is(LoopKind::kCovisible, later, earlier);
        EXPECT_EQ(is_loop, IsFirstPlace(later) && IsFirstPlace(earlier));
        pairs.push_back({later, earlier, is_loop ? 0.5 : 0.9, false});
      }
    }
    return pairs;
  }

  LoopTruth truth_;
};

TEST_F(Stages, TrueJoinsMendWhatScoresMistake) {
  const SequenceTrace cut = {{{0, 2, 0}, {3, 5, 1}, {6, 8, 0}}, {}, {}, {{2, 0}}};
  const auto outcome = MeasureStages(cut, Misled(), truth_, Poses());
  ASSERT_TRUE(outcome.has_value());
  EXPECT_DOUBLE_EQ(outcome->within, 1.0);
  EXPECT_DOUBLE_EQ(outcome->compared, 9.0 / 21.0);
  EXPECT_DOUBLE_EQ(outcome->true_joins, 1.0);
  EXPECT_DOUBLE_EQ(outcome->true_places, 1.0);
}

TEST_F(Stages, LoopsOfSequencesThatAreNotJoinedAreLost) {
  const SequenceTrace cut = {{{0, 2, 0}, {3, 5, 1}, {6, 8, 0}}, {}, {}, {{1, 0}}};
  const auto outcome = MeasureStages(cut, Misled(), truth_, Poses());
  ASSERT_TRUE(outcome.has_value());
  EXPECT_DOUBLE_EQ(outcome->within, 0.0);
  EXPECT_DOUBLE_EQ(outcome->true_joins, 1.0);
}

TEST_F(Stages, SequencesAcrossPlacesLoseEvenIfTheyAreJoinedRightly) {
  const SequenceTrace whole = {{{0, 8, 0}}, {}, {}, {}};
  const auto outcome = MeasureStages(whole, Misled(), truth_, Poses());
  ASSERT_TRUE(outcome.has_value());
  EXPECT_DOUBLE_EQ(outcome->compared, 1.0);
  EXPECT_DOUBLE_EQ(outcome->within, 1.0);
  EXPECT_LT(outcome->true_joins, 0.5);
  EXPECT_DOUBLE_EQ(outcome->true_places, 1.0);
}

TEST_F(Stages, NothingOfADriveWithoutLoops) {
  std::vector<TruthFrame> frames = Frames();
  for (TruthFrame& frame : frames) frame.comparable = 0;
  EXPECT_FALSE(MeasureStages({{{0, 8, 0}}, {}, {}, {}}, {}, LoopTruth(frames, nullptr), Poses()));
}

}  // namespace
}  // namespace bulletnav::bench
