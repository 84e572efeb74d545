// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/label_statistics.h"

#include <gmock/gmock.h>

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

TEST(LabelStatisticsTest, CountsByHand) {
  SceneSamples samples;
  samples.poses.resize(2);
  samples.explorable = {0b1, 0b1110};
  samples.reach.resize(2);
  samples.pairs.resize(4);
  samples.pairs[0].same_node = samples.pairs[3].same_node = 1;  // each with itself
  samples.pairs[1].same_node = 1;
  samples.pairs[2].score.fill(128);
  samples.pairs[2].score[0] = 255;
  LabelStatistics statistics;
  statistics.Add(samples);
  statistics.Add(samples);
  EXPECT_EQ(statistics.pairs(), 8);
  EXPECT_EQ(statistics.connected_share(), 0.5);
  EXPECT_EQ(statistics.mean_explorable(), 2.0);
  EXPECT_EQ(statistics.share_without_explorable(), 0.0);
  EXPECT_EQ(statistics.scores()[5], 22);
  EXPECT_EQ(statistics.scores()[9], 2);
  EXPECT_THAT(statistics.ToText(), HasSubstr("2 scenes, 4 points, 8 pairs"));
}

TEST(LabelStatisticsTest, NothingIsNoTrouble) {
  EXPECT_THAT(LabelStatistics().ToText(), HasSubstr("0 scenes"));
}

}  // namespace
}  // namespace bulletnav::bench
