// SPDX-License-Identifier: MIT
#include "benchmark/episodes/description.h"

#include <gmock/gmock.h>

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

TEST(TextHistogram, CountsEachValueOnce) {
  EXPECT_EQ(TextHistogram({1.0, 1.1, 1.49, 1.5, 2.0, 9.0}, 0.0, 0.5, 6),
            "   1.00 -  1.50       3 ########################################\n"
            "   1.50 -  2.00       1 ##############\n"
            "   2.00 -  2.50       1 ##############\n"
            "   2.50 -  3.00       1 ##############\n");
  EXPECT_EQ(TextHistogram({-3.0}, 0.0, 1.0, 2),
            "   0.00 -  1.00       1 ########################################\n");
  EXPECT_EQ(TextHistogram({}, 0.0, 1.0, 3), "");
}

TEST(DescribeEpisodes, CountsKindsAndScenes) {
  Episode easy;
  easy.scene = "a.glb";
  easy.difficulty = Difficulty::kEasy;
  easy.goals = {{{0, 0, 2}, {}, {}, 3.0}};
  Episode sequence;
  sequence.scene = "b.glb";
  sequence.goals = {{{0, 0, 2}, {}, {}, 2.0}, {{0, 0, 6}, {}, {}, 5.0}};
  const std::string text = DescribeEpisodes({easy, easy, sequence});
  EXPECT_THAT(text, HasSubstr("3 episodes in 2 scenes"));
  EXPECT_THAT(text, HasSubstr("easy                         2"));
  EXPECT_THAT(text, HasSubstr("sequences of 2 goals         1"));
  EXPECT_THAT(text, HasSubstr("metres (mean 3.25)"));
  EXPECT_THAT(text, HasSubstr("straight line (mean 1.31)"));
}

}  // namespace
}  // namespace bulletnav::bench
