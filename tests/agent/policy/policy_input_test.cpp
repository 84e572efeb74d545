// SPDX-License-Identifier: MIT
#include "agent/policy/policy_input.h"

#include <numbers>
#include <vector>

#include <gmock/gmock.h>

namespace bulletnav::agent {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;

TEST(PolicyNumbers, AreTheLastActionTheMotionAndTheTime) {
  Observation observation;
  observation.odometry = {0.25, -0.125, std::numbers::pi / 36};
  observation.step = 125;
  std::vector<float> numbers(kPolicyNumbers, 9.0f);
  WritePolicyNumbers(observation, sim::Action::kTurnLeft, 500, numbers);
  EXPECT_THAT(numbers, ElementsAre(0, 0, 1, 0, 1, -0.5, FloatNear(0.5f, 1e-6f), 0.25));
}

TEST(PolicyNumbers, KnowNoActionAtTheStartAndNoTimeAfterTheEnd) {
  Observation observation;
  std::vector<float> numbers(kPolicyNumbers, 9.0f);
  WritePolicyNumbers(observation, std::nullopt, 500, numbers);
  EXPECT_THAT(numbers, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0));
  observation.step = 900;
  WritePolicyNumbers(observation, std::nullopt, 500, numbers);
  EXPECT_EQ(numbers.back(), 1.0f);
}

TEST(PolicyPictures, HaveNoDepthWhereTheBodyHasNone) {
  const std::vector<std::uint8_t> color(std::size_t{3} * 128 * 512, 255);
  const std::vector<float> depth(std::size_t{128} * 512, 10.0f);
  PolicyPictures pictures(64);
  std::vector<std::uint8_t> bytes(pictures.bytes());
  ASSERT_EQ(bytes.size(), std::size_t{64} * 256 * 4);
  pictures.Write({color, depth}, bytes);
  EXPECT_THAT(std::vector(bytes.begin(), bytes.begin() + 4), ElementsAre(254, 254, 254, 254));
  pictures.Write({color, {}}, bytes);
  EXPECT_THAT(std::vector(bytes.begin(), bytes.begin() + 4), ElementsAre(254, 254, 254, 0));
}

}  // namespace
}  // namespace bulletnav::agent
