// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "sim/simulated_body.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

constexpr int kSteps = 10'000;
constexpr int kEpisodeSteps = 500;

/// Random noisy steps, mostly ahead so that the body meets everything there is to meet.
Action RandomAction(Rng* rng) {
  if (rng->Chance(0.7)) return Action::kMoveForward;
  return rng->Chance(0.5) ? Action::kTurnLeft : Action::kTurnRight;
}

void ResetSomewhere(const NavmeshQuery& query, Rng* rng, int episode, SimulatedBody* body) {
  while (true) {
    try {
      body->Reset({query.RandomPoint(rng, 0).cast<double>(), rng->Uniform(-kPi, kPi)},
                  {1, static_cast<std::uint64_t>(episode)});
      return;
    } catch (const PoseError&) {
      continue;
    }
  }
}

/// Never outside, never inside a wall, never NaN; and never stuck for good.
void Walk(const std::shared_ptr<const World>& world, const BodySpec& spec) {
  const NavmeshQuery query(world->navmesh());
  SimulatedBody body(world, spec, NoiseModel(NoiseMode::kAnsReleased));
  Rng rng(1, world->name());
  double walked = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    if (step % kEpisodeSteps == 0) {
      walked += body.path_length();
      ResetSomewhere(query, &rng, step / kEpisodeSteps, &body);
    }
    const Eigen::Vector3f before = body.true_pose().position.cast<float>();
    const Sensors sensors = body.Step(RandomAction(&rng));
    const Eigen::Vector3f foot = body.true_pose().position.cast<float>();
    ASSERT_TRUE(foot.allFinite());
    ASSERT_TRUE(std::isfinite(sensors.odometry.x + sensors.odometry.y + sensors.odometry.yaw));
    const Capsule torso{foot + Eigen::Vector3f(0, spec.max_climb + spec.radius, 0),
                        spec.height - spec.max_climb - 2 * spec.radius, spec.radius};
    const auto nearest = world->physics().Nearest(torso, spec.radius - 0.0015f);
    ASSERT_FALSE(nearest) << "inside something at step " << step << ": " << foot.transpose();
    ASSERT_FALSE(world->physics().AxisCrosses(torso, before - foot))
        << "through a wall at " << step;
    const Eigen::Vector3f up(0, 0.3f, 0);
    ASSERT_TRUE(world->physics().RayTest(foot + up, foot - up) ||
                world->physics().Nearest({foot, 0.0f, 0.0f}, 2 * spec.radius))
        << "over no floor at step " << step;
  }
  EXPECT_GT(walked, 100.0);
}

TEST(Walk, InARealHouseMadeByOthers) {
  const auto file = tests::SharedScene("aws_small_house");
  if (!file) GTEST_SKIP() << "no shared scene aws_small_house";
  const auto world = World::Load(*file, {});
  Walk(world, {});
  Walk(world, BodySpec::Locobot());
}

}  // namespace
}  // namespace bulletnav::sim
