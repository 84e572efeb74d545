// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/gae.h"

#include <array>

#include <gmock/gmock.h>

#include "benchmark/training/rl/running_moments.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

constexpr GaeSpec kSpec = {0.5, 0.5};

TEST(Gae, IsWhatAHandWorksOut) {
  const std::array<LaneStep, 3> steps = {{{1.0, 2.0}, {0.0, 4.0}, {2.0, 1.0}}};
  std::array<double, 3> advantages;
  EstimateAdvantages(kSpec, steps, 6.0, advantages);
  // Errors: 1 + 2 - 2 = 1, 0 + 0.5 - 4 = -3.5, 2 + 3 - 1 = 4; each takes a quarter of the next.
  EXPECT_THAT(advantages, ElementsAre(DoubleNear(0.375, 1e-12), DoubleNear(-2.5, 1e-12),
                                      DoubleNear(4.0, 1e-12)));
}

TEST(Gae, NothingComesAfterAnEnd) {
  const std::array<LaneStep, 2> steps = {{{1.0, 2.0, true}, {5.0, 100.0}}};
  std::array<double, 2> advantages;
  EstimateAdvantages(kSpec, steps, 0.0, advantages);
  EXPECT_DOUBLE_EQ(advantages[0], -1.0);
}

TEST(Gae, ACutIsWorthWhatWouldHaveComeAndNoMore) {
  const std::array<LaneStep, 2> steps = {{{1.0, 2.0, false, true, 8.0}, {5.0, 100.0}}};
  std::array<double, 2> advantages;
  EstimateAdvantages(kSpec, steps, 0.0, advantages);
  EXPECT_DOUBLE_EQ(advantages[0], 1.0 + 4.0 - 2.0);
}

TEST(Gae, LastValueCountsOnlyIfTheEpisodeGoesOn) {
  for (const bool terminated : {false, true}) {
    const std::array<LaneStep, 1> steps = {{{1.0, 2.0, terminated}}};
    std::array<double, 1> advantages;
    EstimateAdvantages(kSpec, steps, 6.0, advantages);
    EXPECT_DOUBLE_EQ(advantages[0], terminated ? -1.0 : 2.0);
  }
}

TEST(Gae, BadConstantsAreRefused) {
  EXPECT_THROW((GaeSpec{1.5, 0.5}.Validate()), sim::Error);
  EXPECT_THROW((GaeSpec{0.5, -0.1}.Validate()), sim::Error);
}

TEST(RunningMoments, AreThoseOfAllNumbersInAnyPortions) {
  RunningMoments moments;
  EXPECT_EQ(moments.deviation(), 1.0);
  moments.Add(std::array{1.0, 3.0});
  moments.Add(std::array{5.0, 7.0});
  EXPECT_DOUBLE_EQ(moments.mean, 4.0);
  EXPECT_DOUBLE_EQ(moments.deviation(), std::sqrt(5.0));
}

}  // namespace
}  // namespace bulletnav::bench
