// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/drive_traces.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(SimilarityMatrix, HoldsEachPairTwiceInSharesOfTheBest) {
  const std::vector<agent::LoopCandidate> named = {{3, 0, 0.5, false}, {2, 1, 0.25, true}};
  const sim::Image matrix = SimilarityMatrix(named, 4);
  ASSERT_EQ(matrix.width, 4);
  EXPECT_THAT(matrix.pixels, ElementsAre(0, 0, 0, 255, 0, 0, 127, 0, 0, 127, 0, 0, 255, 0, 0, 0));
  EXPECT_THAT(SimilarityMatrix({}, 2).pixels, ElementsAre(0, 0, 0, 0));
}

/// Frames of long drives share cells, which hold the best of them.
TEST(SimilarityMatrix, ShrinksLongDrives) {
  const std::vector<agent::LoopCandidate> named = {
      {1023, 0, 1.0, false}, {1022, 1, 0.2, false}, {512, 256, 0.5, false}};
  const sim::Image matrix = SimilarityMatrix(named, 1024);
  EXPECT_EQ(matrix.width, 256);
  EXPECT_EQ(*matrix.at(255, 0), 255);
  EXPECT_EQ(*matrix.at(0, 255), 255);
  EXPECT_EQ(*matrix.at(128, 64), 127);
}

TEST(DriveTraces, AreReadAsTheyWereWritten) {
  const tests::TemporaryFolder folder;
  agent::SequenceTrace trace;
  trace.sequences = {{0, 4, 1}, {5, 9, 0}, {10, 12, 1}};
  trace.tried = {2, 4};
  trace.spreads = {3.5, 1.25};
  trace.joined = {{2, 0}};
  WriteTrace(folder.path(), "words", trace);
  const agent::SequenceTrace read = ReadTrace(folder.path(), "words");
  ASSERT_EQ(read.sequences.size(), 3u);
  EXPECT_EQ(read.sequences[1].first, 5);
  EXPECT_EQ(read.sequences[1].last, 9);
  EXPECT_EQ(read.sequences[2].cluster, 1);
  EXPECT_EQ(read.tried, trace.tried);
  EXPECT_EQ(read.spreads, trace.spreads);
  EXPECT_EQ(read.joined, trace.joined);
  EXPECT_TRUE(ReadTrace(folder.path(), "none").sequences.empty());
  folder.Write("bad.sequences.yaml",
               "first: [0]\nlast: []\ncluster: [0]\ntried: []\nspreads: []\njoined_later: []\n"
               "joined_earlier: []\n");
  EXPECT_THAT(
      [&] {
        ReadTrace(folder.path(), "bad");
      },
      ThrowsMessage<sim::FileError>(HasSubstr("not of one length")));
}

}  // namespace
}  // namespace bulletnav::bench
