// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/tum.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/slam/io/file_frames.h"
#include "sim/base/error.h"
#include "sim/image/image.h"
#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Tum, ReadsAHandMadeTrajectory) {
  const tests::TemporaryFolder folder;
  const auto trajectory = ReadTumTrajectory(
      folder.Write("groundtruth.txt",
                   "# timestamp tx ty tz qx qy qz qw\n"
                   "1305031098.6659 1.3563 0.6305 1.6380 0.6132 0.5962 -0.3311 -0.3986\n"
                   "1305031098.6758  1.3543 0.6306 1.6360 0 0 0 1\n"));
  ASSERT_EQ(trajectory.size(), 2u);
  EXPECT_EQ(trajectory[0].time, 1305031098.6659);
  EXPECT_EQ(trajectory[1].pose.position, Eigen::Vector3d(1.3543, 0.6306, 1.6360));
  EXPECT_NEAR(trajectory[0].pose.rotation.y(), 0.5962, 1e-4);
}

/// As some editors write UTF-8.
TEST(Tum, AByteOrderMarkIsNoWord) {
  const tests::TemporaryFolder folder;
  EXPECT_EQ(ReadTumTrajectory(folder.Write("t.txt",
                                           "\xEF\xBB\xBF"
                                           "1 2 0 0 0 0 0 1\n"))[0]
                .time,
            1.0);
}

TEST(Tum, WritesWhatItReads) {
  CameraTrajectory trajectory;
  for (int i = 0; i < 6; ++i) {
    trajectory.push_back(
        {1e9 + i / 3.0, CameraInFile(sim::PlanarPose{i / 3.0, i / 7.0, 1.0 * i}, 1.25)});
  }
  const tests::TemporaryFolder folder;
  const auto read = ReadTumTrajectory(folder.Write("t.txt", ToTum(trajectory)));
  ASSERT_EQ(read.size(), trajectory.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].time, trajectory[i].time);
    EXPECT_EQ(read[i].pose.position, trajectory[i].pose.position);
    EXPECT_LT(read[i].pose.rotation.angularDistance(trajectory[i].pose.rotation), 1e-7);
  }
}

TEST(NearestTimes, TakesTheNearestOnce) {
  const std::vector<double> first = {0.0, 1.0, 2.0, 3.0};
  const std::vector<double> second = {0.01, 0.985, 1.005, 2.03};
  EXPECT_THAT(NearestTimes(first, second, 0.02), ElementsAre(std::pair(0, 0), std::pair(1, 2)));
}

/// Takes the nearest pair of all that are left, again and again.
std::vector<std::pair<int, int>> SlowNearestTimes(const std::vector<double>& first,
                                                  const std::vector<double>& second, double most) {
  std::vector<std::pair<int, int>> pairs;
  std::vector<bool> a_taken(first.size(), false);
  std::vector<bool> b_taken(second.size(), false);
  while (true) {
    double least = most;
    int best_a = -1;
    int best_b = -1;
    for (std::size_t a = 0; a < first.size(); ++a) {
      for (std::size_t b = 0; b < second.size(); ++b) {
        const double apart = std::abs(first[a] - second[b]);
        if (a_taken[a] || b_taken[b] || apart > least) continue;
        least = apart;
        best_a = static_cast<int>(a);
        best_b = static_cast<int>(b);
      }
    }
    if (best_a < 0) break;
    a_taken[static_cast<std::size_t>(best_a)] = true;
    b_taken[static_cast<std::size_t>(best_b)] = true;
    pairs.emplace_back(best_a, best_b);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(NearestTimes, IsThatOfTryingAll) {
  sim::Rng rng(1, "times");
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<double> first;
    std::vector<double> second;
    for (int i = 0; i < 40; ++i) {
      first.push_back(rng.Uniform(0.0, 2.0));
      second.push_back(rng.Uniform(0.0, 2.0));
    }
    std::sort(first.begin(), first.end());
    std::sort(second.begin(), second.end());
    EXPECT_EQ(NearestTimes(first, second, 0.1), SlowNearestTimes(first, second, 0.1));
  }
}

class TumFolderTest : public ::testing::Test {
 protected:
  TumFolderTest() {
    folder_.Write("calibration.txt", "525 526 319.5 239.5\n");
    for (const char* name : {"a.png", "b.png", "c.png", "d.png"}) folder_.Write(name, "");
    folder_.Write("rgb.txt", "# colour\n1.00 a.png\n1.10 b.png\n1.20 c.png\n");
    folder_.Write("depth.txt", "1.005 c.png\n1.19 d.png\n");
  }
  void ExpectError(const std::string& what) {
    EXPECT_THAT(
        [&] {
          ReadTumFolder(folder_.path(), {});
        },
        ThrowsMessage<sim::FileError>(HasSubstr(what)));
  }
  tests::TemporaryFolder folder_;
};

TEST_F(TumFolderTest, IsRead) {
  const TumFolder read = ReadTumFolder(folder_.path(), {});
  EXPECT_EQ(read.intrinsics.fy, 526.0);
  EXPECT_TRUE(read.truth.empty());
  ASSERT_EQ(read.frames.size(), 2u);
  EXPECT_EQ(read.frames[0].time, 1.0);
  EXPECT_EQ(read.frames[0].depth.filename(), "c.png");
  EXPECT_EQ(read.frames[1].color.filename(), "c.png");
  EXPECT_EQ(read.frames[1].depth.filename(), "d.png");
  folder_.Write("groundtruth.txt", "1 0 0 0 0 0 0 1\n");
  EXPECT_EQ(ReadTumFolder(folder_.path(), {}).truth.size(), 1u);
}

TEST_F(TumFolderTest, TellsFileAndLine) {
  folder_.Write("depth.txt", "5.005 c.png\n6.19 d.png\n");
  ExpectError("rgb.txt: only 0 of 3 pictures have one of depth.txt within 0.02 s");
  folder_.Write("depth.txt", "1 c.png\n2 none.png\n");
  ExpectError("depth.txt:2: " + (folder_.path() / "none.png").string() + " is not there");
  folder_.Write("depth.txt", "1.2 c.png\n1.1 d.png\n");
  ExpectError("depth.txt:2: time 1.1 is not after the line before it, 1.2");
  folder_.Write("depth.txt", "# none\n");
  ExpectError("depth.txt: names no pictures");
  folder_.Write("calibration.txt", "0 1 2 3\n");
  ExpectError("calibration.txt:1: fx and fy must be positive");
  std::filesystem::remove(folder_.path() / "calibration.txt");
  ExpectError("calibration.txt: is not there, so the intrinsics are unknown; write");
}

TEST(TumDepth, IsWrittenAndRead) {
  const tests::TemporaryFolder folder;
  const DepthPicture picture = {3, 2, {0.0f, 1.0f, 2.50035f, 13.107f, 13.2f, std::nanf("")}};
  WriteTumDepth(folder.path() / "d.png", picture);
  const DepthPicture read = ReadTumDepth(folder.path() / "d.png");
  EXPECT_EQ(read.width, 3);
  EXPECT_EQ(read.height, 2);
  EXPECT_THAT(read.metres, ElementsAre(0.0f, 1.0f, 2.5004f, 13.107f, 0.0f, 0.0f));
}

TEST(TumDepth, TellsBrokenDepth) {
  const tests::TemporaryFolder folder;
  EXPECT_THAT(
      [&] {
        ReadTumDepth(folder.Write("d.png", "no picture"));
      },
      ThrowsMessage<sim::FileError>(HasSubstr("depth is a 16-bit grey PNG")));
  sim::WritePng(folder.path() / "rgb.png", sim::Image(4, 4, 3));
  EXPECT_THAT(
      [&] {
        ReadTumDepth(folder.path() / "rgb.png");
      },
      ThrowsMessage<sim::FileError>(HasSubstr("rgb.png: ")));
}

TEST(Tum, TellsFileAndLine) {
  const tests::TemporaryFolder folder;
  const auto expect = [&](const std::string& text, const std::string& what) {
    EXPECT_THAT(
        [&] {
          ReadTumTrajectory(folder.Write("t.txt", text));
        },
        ThrowsMessage<sim::FileError>(HasSubstr("t.txt:" + what)));
  };
  expect("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n", "2: time 1 is not after");
  expect("1 0 0 0 0 0 1\n", "1: expected 8 words, 't x y z qx qy qz qw', and found 7");
  expect("1 0 0 nan 0 0 0 1\n", "1: 'nan' is not finite");
  expect("1 0 0 0 0 0 0 0.5\n", "1: the quaternion");
  expect("1 0 2e7 0 0 0 0 1\n", "1: the place is more than 1e7 m away");
  expect("# nothing\n", " there are no poses");
}

}  // namespace
}  // namespace bulletnav::bench
