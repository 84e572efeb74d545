// SPDX-License-Identifier: MIT
#include "benchmark/slam/truth/loop_truth.h"

#include <cmath>

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

constexpr Intrinsics kCamera = {160.0, 160.0, 159.5, 119.5};

/// A picture of 320 x 240 of a wall straight across, so many metres ahead.
DepthThumbnail WallAhead(float metres) {
  return Coarsened({320, 240, std::vector<float>(320 * 240, metres)}, kCamera);
}

/// The body at a place of the plane: x ahead, y to the left of where the world looks along.
sim::BodyPose At(double x, double y, double yaw) {
  return sim::Apply({}, {x, y, yaw});
}

TEST(Covisibility, AViewSeesAllOfItself) {
  EXPECT_DOUBLE_EQ(Covisibility(WallAhead(3.0f), WallAhead(3.0f), {}), 1.0);
}

/// Half the width of what is seen 3 m ahead is 3 m: moved aside by that much, half is left.
TEST(Covisibility, MovedAsideSeesTheShareThatGeometrySays) {
  const DepthThumbnail wall = WallAhead(3.0f);
  EXPECT_NEAR(Covisibility(wall, wall, {0.0, 3.0, 0.0}), 0.5, 0.06);
  EXPECT_NEAR(Covisibility(wall, wall, {0.0, -1.5, 0.0}), 0.75, 0.06);
  EXPECT_EQ(Covisibility(wall, wall, {0.0, 7.0, 0.0}), 0.0);
}

/// From nearer, a part of the wall is seen: all points of the near view, a quarter of the far one.
TEST(Covisibility, IsTheSmallerShareOfTheTwo) {
  const DepthThumbnail far = WallAhead(4.0f);
  const DepthThumbnail near = WallAhead(2.0f);
  EXPECT_DOUBLE_EQ(ShareSeen(near, far, {-2.0, 0.0, 0.0}), 1.0);
  EXPECT_NEAR(ShareSeen(far, near, {2.0, 0.0, 0.0}), 0.25, 0.05);
  EXPECT_NEAR(Covisibility(far, near, {2.0, 0.0, 0.0}), 0.25, 0.05);
}

TEST(Covisibility, WhatIsHiddenIsNotSeen) {
  EXPECT_EQ(Covisibility(WallAhead(3.0f), WallAhead(1.0f), {}), 0.0);
  EXPECT_EQ(Covisibility(WallAhead(3.0f), WallAhead(3.0f), {0.0, 0.0, sim::kPi}), 0.0);
  EXPECT_EQ(Covisibility(WallAhead(0.0f), WallAhead(0.0f), {}), 0.0);
}

TEST(HeadingBin, TurnsCountToEitherSide) {
  EXPECT_EQ(HeadingBinOf(0.1), HeadingBin::kAlong);
  EXPECT_EQ(HeadingBinOf(-1.0), HeadingBin::kAside);
  EXPECT_EQ(HeadingBinOf(2.0), HeadingBin::kAcross);
  EXPECT_EQ(HeadingBinOf(2.0 * sim::kPi - 3.0), HeadingBin::kOpposite);
}

TEST(LoopTruth, KnowsEachKindOfLoop) {
  const std::vector<TruthFrame> frames = {{At(0.0, 0.0, 0.0), WallAhead(3.0f), 0},
                                          {At(0.0, 9.0, 0.0), WallAhead(3.0f), 1},
                                          {At(0.0, 0.5, 0.1), WallAhead(3.0f), 2},
                                          {At(0.0, 3.0, sim::kPi), WallAhead(3.0f), 3}};
  const LoopTruth truth(frames, [](const sim::BodyPose& a, const sim::BodyPose& b) {
    return (a.position - b.position).norm() < 1.0;
  });
  EXPECT_EQ(truth.frames(), 4);
  EXPECT_EQ(truth.pairs(), 6);
  EXPECT_TRUE(truth.Is(LoopKind::kCovisible, 2, 0));
  EXPECT_TRUE(truth.Is(LoopKind::kNode, 2, 0));
  EXPECT_TRUE(truth.Is(LoopKind::kNear, 3, 0));
  EXPECT_FALSE(truth.Is(LoopKind::kCovisible, 3, 0));
  EXPECT_FALSE(truth.Is(LoopKind::kNear, 1, 0));
  EXPECT_EQ(truth.Heading(3, 0), HeadingBin::kOpposite);
  EXPECT_EQ(truth.Count(LoopKind::kNear), 3);
  EXPECT_EQ(truth.Count(LoopKind::kNode), 1);
  EXPECT_EQ(truth.Count(LoopKind::kCovisible), 1);
  EXPECT_EQ(truth.Count(LoopKind::kCovisible, HeadingBin::kAlong), 1);
  EXPECT_EQ(truth.pairs(HeadingBin::kOpposite), 3);
  EXPECT_TRUE(truth.HasLoop(LoopKind::kCovisible, 2));
  EXPECT_FALSE(truth.HasLoop(LoopKind::kCovisible, 3));
}

}  // namespace
}  // namespace bulletnav::bench
