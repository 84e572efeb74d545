// SPDX-License-Identifier: MIT
#include "tests/support/scene_checks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "sim/render/cpu/cpu_scene.h"
#include "sim/simulated_body.h"
#include "tests/support/panoramas.h"

namespace bulletnav::tests {
namespace {

using namespace sim;  // NOLINT(google-build-using-namespace): these are checks of sim

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

std::vector<CameraPose> Cameras(const World& world, int places) {
  const NavmeshQuery query(world.navmesh());
  Rng rng(3, world.name());
  SimulatedBody body(std::shared_ptr<const World>(std::shared_ptr<const World>(), &world), {},
                     NoiseModel(NoiseMode::kNone));
  std::vector<CameraPose> cameras;
  for (int i = 0; i < places; ++i) {
    ResetSomewhere(query, &rng, i, &body);
    const Eigen::Vector3f foot = body.true_pose().position.cast<float>();
    cameras.push_back({foot + Eigen::Vector3f(0, static_cast<float>(BodySpec().camera_height), 0),
                       static_cast<float>(body.true_pose().yaw)});
  }
  return cameras;
}

}  // namespace

void CheckWalk(const std::shared_ptr<const World>& world, const BodySpec& spec) {
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

void CheckBackendsAgree(const SceneMesh& mesh, const World& world, int places) {
  std::unique_ptr<const RenderScene> egl;
  try {
    egl = MakeRenderScene(mesh, Backend::kEgl);
  } catch (const RenderError& e) {
    GTEST_SKIP() << e.what();
  }
  const auto embree = MakeRenderScene(mesh, Backend::kEmbree);
  Agreement agreement;
  for (const CameraPose& camera : Cameras(world, places)) {
    agreement.Add(RenderPanorama(*embree, {}, camera), RenderPanorama(*egl, {}, camera));
  }
  EXPECT_GE(agreement.depth(), 0.995);
  EXPECT_GE(agreement.color(), 0.99);
}

void CheckDepthAgainstPhysics(const World& world, int places) {
  PanoramaSpec spec;
  spec.cols = 128;
  spec.rows = 32;
  constexpr float kFar = 60.0f;
  spec.max_depth_m = kFar;
  int wrong = 0;
  int count = 0;
  for (const CameraPose& camera : Cameras(world, places)) {
    const Panorama picture = RenderPanorama(world.render_scene(), spec, camera);
    for (int r = 0; r < spec.rows; ++r) {
      for (int c = 0; c < spec.cols; ++c) {
        const Eigen::Vector3f way = RayDirection(spec, r, c, camera.yaw);
        const auto hit = world.physics().RayTest(camera.position, camera.position + kFar * way);
        const float expected = hit ? kFar * hit->fraction : 0.0f;
        const float seen = picture.depth_at(r, c);
        wrong += std::abs(seen - expected) > 1e-3f * expected + 2e-3f ? 1 : 0;
        ++count;
      }
    }
  }
  // Rays that graze an edge may fall on either side of it.
  EXPECT_LE(wrong, count / 500) << "of " << count;
}

}  // namespace bulletnav::tests
