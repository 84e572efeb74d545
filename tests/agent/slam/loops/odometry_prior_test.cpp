// SPDX-License-Identifier: MIT
#include "agent/slam/loops/odometry_prior.h"

#include <vector>

#include <gtest/gtest.h>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

/// Steps of a body that walks a room's length, turns, walks on.
std::vector<sim::PlanarPose> Steps(int count) {
  std::vector<sim::PlanarPose> steps;
  for (int i = 0; i < count; ++i) {
    const bool turns = i % 20 >= 14;
    steps.push_back(turns ? sim::PlanarPose{0.0, 0.0, 0.3} : sim::PlanarPose{0.25, 0.0, 0.0});
  }
  return steps;
}

std::vector<sim::PlanarPose> Added(const std::vector<sim::PlanarPose>& steps) {
  std::vector<sim::PlanarPose> poses{{}};
  for (const sim::PlanarPose& step : steps) poses.push_back(sim::Compose(poses.back(), step));
  return poses;
}

OdometryTrack TrackOf(const std::vector<sim::PlanarPose>& poses) {
  OdometryTrack track;
  for (const sim::PlanarPose& pose : poses) track.Add(pose);
  return track;
}

/// The formula beside thousands of drives whose steps err as it says.
TEST(OdometryTrack, VarianceIsThatOfDrivesWithSuchErrors) {
  constexpr int kSteps = 90;
  constexpr int kEarlier = 25;
  constexpr int kDrives = 4000;
  const std::vector<sim::PlanarPose> steps = Steps(kSteps);
  const std::vector<sim::PlanarPose> poses = Added(steps);
  const sim::PlanarPose seen = sim::Compose(sim::Inverse(poses[kEarlier]), poses.back());
  sim::Rng rng(3, "drives");
  double sum = 0.0;
  for (int drive = 0; drive < kDrives; ++drive) {
    const double shared = sim::DegToRad(0.1) * rng.Normal();
    std::vector<sim::PlanarPose> wrong = steps;
    for (sim::PlanarPose& step : wrong) {
      step.x += 0.01 * rng.Normal();
      step.y += 0.01 * rng.Normal();
      step.yaw += shared + sim::DegToRad(0.3) * rng.Normal();
    }
    const std::vector<sim::PlanarPose> off = Added(wrong);
    const sim::PlanarPose now = sim::Compose(sim::Inverse(off[kEarlier]), off.back());
    sum += (now.x - seen.x) * (now.x - seen.x) + (now.y - seen.y) * (now.y - seen.y);
  }
  const double variance = TrackOf(poses).Variance(kSteps, kEarlier);
  EXPECT_NEAR(variance / (sum / kDrives), 1.0, 0.1);
}

TEST(OdometryTrack, SpeaksAgainstWhatIsFarApartAsSurelyAsItIs) {
  std::vector<sim::PlanarPose> poses;
  for (int i = 0; i < 200; ++i) poses.push_back({0.25 * i, 0.0, 0.0});
  const OdometryTrack track = TrackOf(poses);
  const OdometryPriorSpec spec{.odometry_weight = 0.1, .odometry_reach_m = 4.0};
  EXPECT_DOUBLE_EQ(track.Apart(40, 0), 10.0);
  EXPECT_EQ(track.Against(16, 0, spec), 0.0);  // 4 m
  EXPECT_GT(track.Against(17, 0, spec), 0.0);
  EXPECT_LT(track.Against(17, 0, spec), track.Against(20, 0, spec));
  EXPECT_EQ(track.Against(199, 0, {}), 0.0);  // not asked
  EXPECT_LE(track.Against(199, 0, {.odometry_weight = 100.0}), 2.0);
  // The same distance after a longer way is less sure.
  std::vector<sim::PlanarPose> detour = poses;
  for (int i = 199; i >= 40; --i) detour.push_back(poses[static_cast<std::size_t>(i)]);
  const OdometryTrack longer = TrackOf(detour);
  const int last = static_cast<int>(detour.size()) - 1;
  EXPECT_DOUBLE_EQ(longer.Apart(last, 0), 10.0);
  EXPECT_GT(longer.Variance(last, 0), longer.Variance(40, 0));
  EXPECT_LT(longer.Against(last, 0, spec), longer.Against(40, 0, spec));
}

TEST(OdometryPriorSpec, RefusesWhatIsNegative) {
  EXPECT_THROW(OdometryPriorSpec{.odometry_weight = -0.1}.Validate(), sim::Error);
  EXPECT_THROW(OdometryPriorSpec{.odometry_reach_m = -1.0}.Validate(), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
