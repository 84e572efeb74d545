// SPDX-License-Identifier: MIT
#include "agent/nts/view_ghosts.h"

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

TEST(GhostsOfView, PutsTheShortestWayFirst) {
  std::array<float, kDirections> open = {};
  std::array<float, kDirections> score = {};
  open.fill(1.0f);
  score.fill(0.5f);
  score[7] = 0.75f;
  const auto ghosts = GhostsOfView({}, open, score);
  ASSERT_EQ(ghosts.size(), 12u);
  EXPECT_EQ(ghosts[0].direction, 7);
  EXPECT_DOUBLE_EQ(ghosts[0].distance, 3.0);
  EXPECT_DOUBLE_EQ(ghosts[0].way, 3.0 + 5.0);
  EXPECT_EQ(ghosts[1].direction, 0);
}

TEST(GhostsOfView, WhatIsNotExplorableIsNearerAndHasAPenalty) {
  NtsSpec spec;
  spec.policy.near_ghost = 1.0;
  spec.policy.near_penalty = 4.0;
  std::array<float, kDirections> open = {};
  std::array<float, kDirections> score = {};
  score.fill(0.5f);
  open[5] = 0.5f;
  const auto ghosts = GhostsOfView(spec, open, score);
  EXPECT_EQ(ghosts[0].direction, 5);
  EXPECT_DOUBLE_EQ(ghosts[1].distance, 1.0);
  EXPECT_DOUBLE_EQ(ghosts[1].way, 1.0 + 10.0 + 4.0);
}

}  // namespace
}  // namespace bulletnav::agent
