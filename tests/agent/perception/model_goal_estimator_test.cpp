// SPDX-License-Identifier: MIT
#include "agent/perception/model_goal_estimator.h"

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

/// Codes are a panorama's first byte; the probability of one node falls with their difference.
class ByteModel final : public SemanticModel {
 public:
  std::vector<PanoramaCode> Encode(std::span<const Panorama> panoramas) override {
    ++encoded;
    return {{static_cast<float>(panoramas[0].color[0])}};
  }
  std::array<float, kDirections> Explorable(const PanoramaCode& /*source*/) override { return {}; }
  std::vector<PairPrediction> Compare(std::span<const PanoramaCode* const> sources,
                                      const PanoramaCode& goal) override {
    PairPrediction prediction;
    prediction.same_node = 1.0f - (goal[0] - (*sources[0])[0]) / 10.0f;
    prediction.direction[3] = 1.0f;
    prediction.distance = 2.5f;
    return {prediction};
  }
  int encoded = 0;
};

TEST(ModelGoalEstimator, SeesTheGoalFromTheCertaintyOn) {
  ModelGoalEstimator estimator(std::make_shared<ByteModel>(), 0.65);
  const std::vector<std::uint8_t> near = {7};
  const std::vector<std::uint8_t> far = {6};
  const std::vector<std::uint8_t> goal = {10};
  EXPECT_FALSE(estimator.Estimate({far, {}}, {goal, {}}));
  const auto seen = estimator.Estimate({near, {}}, {goal, {}});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->distance, 2.5, 1e-6);
  EXPECT_NEAR(seen->bearing, sim::kPi / 2, 1e-6);
}

TEST(ModelGoalEstimator, EncodesAGoalOnceAndNoticesAnotherInTheSameMemory) {
  const auto model = std::make_shared<ByteModel>();
  ModelGoalEstimator estimator(model, 0.75);
  const std::vector<std::uint8_t> here = {10};
  std::vector<std::uint8_t> goal = {11};
  EXPECT_TRUE(estimator.Estimate({here, {}}, {goal, {}}));
  EXPECT_TRUE(estimator.Estimate({here, {}}, {goal, {}}));
  EXPECT_EQ(model->encoded, 3);
  goal[0] = 20;
  EXPECT_FALSE(estimator.Estimate({here, {}}, {goal, {}}));
}

}  // namespace
}  // namespace bulletnav::agent
