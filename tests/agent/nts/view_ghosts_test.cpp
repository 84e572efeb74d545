// SPDX-License-Identifier: MIT
#include "agent/nts/view_ghosts.h"

#include <gtest/gtest.h>

#include "agent/perception/relative_pose.h"

namespace bulletnav::agent {
namespace {

using Directions = std::array<float, kDirections>;

NtsSpec SpecOf(double path_weight) {
  NtsSpec spec;
  spec.policy.path_weight = path_weight;
  return spec;
}

TEST(GhostsOfView, PutsTheShortestWayFirst) {
  Directions open = {};
  Directions score = {};
  open.fill(1.0f);
  score.fill(0.5f);
  score[7] = 0.75f;
  const auto ghosts = GhostsOfView(SpecOf(2.0), open, score, {});
  ASSERT_EQ(ghosts.size(), 12u);
  EXPECT_DOUBLE_EQ(ghosts[0].bearing, BearingOf(7));
  EXPECT_DOUBLE_EQ(ghosts[0].distance, 3.0);
  EXPECT_DOUBLE_EQ(ghosts[0].way, 2.0 * 3.0 + 5.0);
  EXPECT_DOUBLE_EQ(ghosts[1].bearing, BearingOf(0));
}

TEST(GhostsOfView, OnlyWhatIsExplorableAndOpeningsCount) {
  Directions open = {};
  Directions score = {};
  score.fill(0.5f);
  score[3] = 0.6f;
  open[5] = 0.5f;
  const std::vector<Opening> openings = {{BearingOf(3) - 0.2, 1.25}};
  const auto ghosts = GhostsOfView(SpecOf(1.0), open, score, openings);
  ASSERT_EQ(ghosts.size(), 2u);
  EXPECT_DOUBLE_EQ(ghosts[0].bearing, BearingOf(3) - 0.2);
  EXPECT_NEAR(ghosts[0].way, 1.25 + 8.0, 1e-6) << "the score of the direction it lies in";
  EXPECT_DOUBLE_EQ(ghosts[1].bearing, BearingOf(5));
}

}  // namespace
}  // namespace bulletnav::agent
