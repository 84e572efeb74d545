// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/kitti.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/slam/io/file_frames.h"
#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// The second camera is 2 m ahead of the first, 1 m to its right, and looks to its right.
constexpr const char* kPoses =
    "1 0 0 0 0 1 0 0 0 0 1 0\n"
    "0 0 1 1 0 1 0 0 -1 0 0 2\n";

TEST(Kitti, ReadsHandMadePoses) {
  const tests::TemporaryFolder folder;
  const auto trajectory =
      ReadKittiTrajectory(folder.Write("00.txt", kPoses), folder.Write("times.txt", "0\n1.5e-1\n"));
  ASSERT_EQ(trajectory.size(), 2u);
  EXPECT_EQ(trajectory[1].time, 0.15);
  const sim::PlanarPose first = PlanarFromFile(trajectory[0].pose);
  EXPECT_NEAR(first.x, 0.0, 1e-12);
  EXPECT_NEAR(first.yaw, 0.0, 1e-12);
  const sim::PlanarPose second = PlanarFromFile(trajectory[1].pose);
  EXPECT_NEAR(second.x, 2.0, 1e-12);
  EXPECT_NEAR(second.y, -1.0, 1e-12);
  EXPECT_NEAR(second.yaw, -sim::kPi / 2, 1e-12);
}

TEST(Kitti, WritesWhatItReads) {
  const tests::TemporaryFolder folder;
  CameraTrajectory trajectory;
  for (int i = 0; i < 5; ++i) {
    trajectory.push_back(
        {0.1 * i, CameraInFile(sim::PlanarPose{0.3 * i, 0.1 * i * i, 0.7 * i}, 1.25)});
  }
  const auto read = ReadKittiTrajectory(folder.Write("p.txt", ToKitti(trajectory)),
                                        folder.Write("t.txt", ToKittiTimes(trajectory)));
  ASSERT_EQ(read.size(), trajectory.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].time, trajectory[i].time);
    // Their world begins at the first camera, which stood at the origin but for its height.
    Eigen::Vector3d position = trajectory[i].pose.position;
    position.z() -= 1.25;
    EXPECT_LT((read[i].pose.position - position).norm(), 1e-12);
    EXPECT_LT(read[i].pose.rotation.angularDistance(trajectory[i].pose.rotation), 1e-7);
  }
}

TEST(Kitti, ReadsCalibrations) {
  const tests::TemporaryFolder folder;
  const auto file = folder.Write("calib.txt",
                                 "P0: 700 0 600 0 0 710 180 0 0 0 1 0\n"
                                 "P2: 720 0 610 45 0 721 172 0 0 0 1 0\n");
  const Intrinsics k = ReadKittiCalibration(file, 2);
  EXPECT_THAT((std::array{k.fx, k.fy, k.cx, k.cy}), ElementsAre(720, 721, 610, 172));
  EXPECT_THAT(
      [&] {
        ReadKittiCalibration(file, 1);
      },
      ThrowsMessage<sim::FileError>(HasSubstr("there is no line 'P1:', so the intrinsics")));
  const auto written = folder.Write("own.txt", ToKittiCalibration({160, 161, 159.5, 119.5}));
  const Intrinsics own = ReadKittiCalibration(written, 3);
  EXPECT_THAT((std::array{own.fx, own.fy, own.cx, own.cy}), ElementsAre(160, 161, 159.5, 119.5));
}

TEST(Kitti, TellsFileAndLine) {
  const tests::TemporaryFolder folder;
  const auto poses = folder.Write("p.txt", kPoses);
  EXPECT_THAT(
      [&] {
        ReadKittiTrajectory(poses, folder.Write("t.txt", "0\n1\n2\n"));
      },
      ThrowsMessage<sim::FileError>(HasSubstr("t.txt: 3 times for 2 poses of")));
  EXPECT_THAT(
      [&] {
        ReadKittiTimes(folder.Write("t.txt", "0\n1\n1\n"));
      },
      ThrowsMessage<sim::FileError>(
          HasSubstr("t.txt:3: time 1 is not after the line before it, 1; ")));
  EXPECT_THAT(
      [&] {
        ReadKittiPoses(folder.Write("q.txt", "1 0 0 0 0 1 0 0 0 0 1\n"));
      },
      ThrowsMessage<sim::FileError>(HasSubstr("q.txt:1: expected 12 words")));
  EXPECT_THAT(
      [&] {
        ReadKittiPoses(folder.Write("q.txt", "1 0 0 0 0 1 0 0 0 0 -1 0\n"));
      },
      ThrowsMessage<sim::FileError>(HasSubstr("q.txt:1: the numbers are no rotation")));
  EXPECT_THAT(
      [&] {
        ReadKittiPoses(folder.Write("q.txt", "2 0 0 0 0 1 0 0 0 0 1 0\n"));
      },
      ThrowsMessage<sim::FileError>(HasSubstr("no rotation")));
  EXPECT_THAT(
      [&] {
        ReadKittiPoses(folder.Write("q.txt", ""));
      },
      ThrowsMessage<sim::FileError>(HasSubstr("there are no poses")));
}

TEST(Kitti, TheBaselineIsThatBetweenTwoCameras) {
  const tests::TemporaryFolder folder;
  const auto file = folder.Write(
      "calib.txt",
      "P2: 700 0 600 45 0 700 180 0 0 0 1 0\nP3: 700 0 600 -333 0 700 180 0 0 0 1 0\n");
  EXPECT_NEAR(ReadKittiBaseline(file, 2, 3), 0.54, 1e-12);
  EXPECT_THAT(
      [&] {
        ReadKittiBaseline(file, 3, 2);
      },
      ThrowsMessage<sim::FileError>(HasSubstr("not beside each other")));
}

}  // namespace
}  // namespace bulletnav::bench
