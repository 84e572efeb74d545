// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/file_frames.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// A body at (2, 0.5, -3) that has turned left by a right angle looks along the simulator's -x:
/// what it sees ahead, to the right and below is there in the file's world, too.
TEST(FileFrames, ACameraSeesTheSameInBothWorlds) {
  const sim::BodyPose body = {{2.0, 0.5, -3.0}, sim::kPi / 2};
  const agent::SpatialPose camera = CameraInFile(body, 1.25);
  const auto in_file = [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(-p.z(), -p.x(), p.y());
  };
  const Eigen::Vector3d eye(2.0, 1.75, -3.0);
  EXPECT_LT((camera.position - in_file(eye)).norm(), 1e-12);
  const auto seen = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
    return camera.rotation.conjugate() * (in_file(point) - camera.position);
  };
  const Eigen::Vector3d ahead = eye + body.forward();
  EXPECT_LT((ahead - Eigen::Vector3d(1.0, 1.75, -3.0)).norm(), 1e-12);
  EXPECT_LT((seen(ahead) - Eigen::Vector3d(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT((seen(eye - body.left()) - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((seen(eye - Eigen::Vector3d::UnitY()) - Eigen::Vector3d(0, 1, 0)).norm(), 1e-12);
}

TEST(FileFrames, ThereAndBackIsTheSame) {
  for (const double yaw : {-3.0, -1.0, 0.0, 0.4, 2.9}) {
    const sim::BodyPose body = {{1.0, 2.0, 3.0}, yaw};
    const sim::BodyPose back = BodyFromFile(CameraInFile(body, 0.7), 0.7);
    EXPECT_LT((back.position - body.position).norm(), 1e-12);
    EXPECT_NEAR(back.yaw, yaw, 1e-12);
  }
}

/// What a body measures of its motion is the same in both worlds.
TEST(FileFrames, MotionIsTheSame) {
  const sim::BodyPose a = {{1.0, 0.0, 3.0}, 0.3};
  const sim::BodyPose b = Apply(a, {0.5, -0.2, 0.9});
  const sim::PlanarPose motion =
      Compose(Inverse(PlanarFromFile(CameraInFile(a, 1.0))), PlanarFromFile(CameraInFile(b, 1.0)));
  EXPECT_NEAR(motion.x, 0.5, 1e-12);
  EXPECT_NEAR(motion.y, -0.2, 1e-12);
  EXPECT_NEAR(motion.yaw, 0.9, 1e-12);
}

/// Turned about its own axis x, to the right, a camera looks up: ahead rises.
TEST(FileFrames, LevelFromCameraIsWhatIsLeftOut) {
  agent::SpatialPose camera = CameraInFile(sim::PlanarPose{1.0, 2.0, 0.8}, 1.0);
  EXPECT_LT((LevelFromCamera(camera) - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  camera.rotation = camera.rotation * agent::RotationBy({0.3, 0.0, 0.0});
  const Eigen::Matrix3d level = LevelFromCamera(camera);
  EXPECT_LT((level * Eigen::Vector3d::UnitX() - Eigen::Vector3d(std::cos(0.3), 0.0, std::sin(0.3)))
                .norm(),
            1e-12);
  EXPECT_LT((level * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
}

TEST(FileFrames, PitchIsLeftOutAndStraightDownIsAnError) {
  agent::SpatialPose camera = CameraInFile(sim::PlanarPose{0.0, 0.0, 0.8}, 1.0);
  camera.rotation = camera.rotation * agent::RotationBy({0.3, 0.0, 0.0});
  EXPECT_NEAR(PlanarFromFile(camera).yaw, 0.8, 1e-12);
  camera.rotation = agent::RotationBy({sim::kPi, 0.0, 0.0});
  EXPECT_THROW(PlanarFromFile(camera), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
