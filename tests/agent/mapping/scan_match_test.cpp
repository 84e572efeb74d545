// SPDX-License-Identifier: MIT
#include "agent/mapping/scan_match.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/math/rng.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::agent {
namespace {

/// A room of 6 x 5 m with a pillar, or a corridor without ends in sight; its middle is the origin
/// of the plane, whose x axis is the world's -z.
class Place {
 public:
  explicit Place(const sim::SceneMesh& mesh)
      : scene_(sim::MakeRenderScene(mesh, sim::Backend::kEmbree)) {}

  std::vector<float> Depth(const sim::PlanarPose& pose) const {
    const sim::BodyPose body = sim::Apply({{3, 0, -2.5}, 0.0}, pose);
    const Eigen::Vector3d eye = body.position + Eigen::Vector3d(0, 1.25, 0);
    return tests::RenderPanorama(*scene_, {}, {eye.cast<float>(), static_cast<float>(body.yaw)})
        .depth;
  }

 private:
  std::unique_ptr<const sim::RenderScene> scene_;
};

Place Room() {
  sim::SceneMesh mesh = tests::BoxRoom(6, 2.6f, 5);
  tests::AddBox({4.5f, 0, -4}, {4.8f, 2.6f, -3.7f}, {9, 9, 9}, &mesh);
  return Place(mesh);
}

sim::PlanarPose Off(const sim::PlanarPose& truth, sim::Rng* rng) {
  return {truth.x + rng->Uniform(-0.05, 0.05), truth.y + rng->Uniform(-0.05, 0.05),
          truth.yaw + rng->Uniform(-0.05, 0.05)};
}

TEST(ScanMatch, FindsTheMotionOfAStep) {
  const Place room = Room();
  sim::Rng rng(3, "match");
  ScanMatch match(Rig{});
  sim::PlanarPose at;
  match.Match({{}, room.Depth(at)}, {});
  for (int i = 0; i < 40; ++i) {
    const sim::PlanarPose step = i % 3 == 0 ? sim::PlanarPose{0.25, 0.01, 0.02}
                                            : sim::PlanarPose{0.0, 0.01, i % 4 < 3 ? 0.3 : -0.25};
    const sim::PlanarPose next = sim::Compose(at, step);
    if (std::hypot(next.x, next.y) > 1.2) continue;
    at = next;
    const sim::PlanarPose found = match.Match({{}, room.Depth(at)}, Off(step, &rng));
    EXPECT_NEAR(found.x, step.x, 0.01) << i;
    EXPECT_NEAR(found.y, step.y, 0.01) << i;
    EXPECT_NEAR(found.yaw, step.yaw, 0.005) << i;
  }
}

TEST(ScanMatch, ErrorsDoNotAddUp) {
  const Place room = Room();
  sim::Rng rng(4, "match");
  ScanMatch match(Rig{});
  sim::PlanarPose at;
  sim::PlanarPose believed;
  match.Match({{}, room.Depth(at)}, {});
  for (int i = 0; i < 72; ++i) {
    const sim::PlanarPose step{0.0, 0.0, sim::DegToRad(10.0)};
    at = sim::Compose(at, step);
    sim::PlanarPose odometry = Off(step, &rng);
    odometry.yaw += 0.01;  // and always too far to the left
    believed = sim::Compose(believed, match.Match({{}, room.Depth(at)}, odometry));
  }
  EXPECT_NEAR(believed.yaw, 0.0, 0.03) << "0.72 by the odometry";
  EXPECT_LT(std::hypot(believed.x, believed.y), 0.1);
}

TEST(ScanMatch, AlongWallsWithoutAnEndTheOdometryCounts) {
  const Place far(tests::BoxRoom(6, 2.6f, 60));
  ScanMatch match(Rig{});
  match.Match({{}, far.Depth({25.0, 0.0, 0.0})}, {});
  const sim::PlanarPose found = match.Match({{}, far.Depth({25.25, 0.0, 0.03})}, {0.20, 0.04, 0.0});
  EXPECT_NEAR(found.x, 0.20, 0.02);
  EXPECT_NEAR(found.y, 0.0, 0.01);
  EXPECT_NEAR(found.yaw, 0.03, 0.005);
}

TEST(ScanMatch, WhereNothingFitsTheOdometryStays) {
  const Place room = Room();
  ScanMatch match(Rig{});
  const sim::PlanarPose odometry{0.1, 0.2, 0.3};
  const std::vector<float> blank(sim::PanoramaSpec{}.pixels(), 0.0f);
  const std::vector<float> broken(blank.size(), std::nanf(""));
  for (const auto& depth : {room.Depth({}), blank, broken, room.Depth({})}) {
    const sim::PlanarPose found = match.Match({{}, depth}, odometry);
    EXPECT_EQ(found.x, odometry.x);
    EXPECT_EQ(found.yaw, odometry.yaw);
  }
}

}  // namespace
}  // namespace bulletnav::agent
