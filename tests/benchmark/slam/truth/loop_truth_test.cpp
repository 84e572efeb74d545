// SPDX-License-Identifier: MIT
#include "benchmark/slam/truth/loop_truth.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/math/rng.h"

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

/// A room without furniture, walls of no thickness, that a camera 1.2 m above its floor looks at.
struct Box {
  double x0, x1, y0, y1;
  double up = 1.4;
  double down = 1.2;
};

/// What is seen from a place inside: all planes are met, the nearest first.
DepthThumbnail Inside(const Box& box, const sim::PlanarPose& pose) {
  DepthPicture picture{320, 240, {}};
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  const auto along = [](double way, double low, double high) {
    return way > 0.0 ? high / way : way < 0.0 ? low / way : INFINITY;
  };
  for (int row = 0; row < picture.height; ++row) {
    for (int col = 0; col < picture.width; ++col) {
      const double left = -(col - kCamera.cx) / kCamera.fx;
      const double up = -(row - kCamera.cy) / kCamera.fy;
      const double depth = std::min({along(c - s * left, box.x0 - pose.x, box.x1 - pose.x),
                                     along(s + c * left, box.y0 - pose.y, box.y1 - pose.y),
                                     along(up, -box.down, box.up)});
      picture.metres.push_back(static_cast<float>(depth));
    }
  }
  return Coarsened(picture, kCamera);
}

/// At least 18 cm from the walls, as a body keeps.
sim::PlanarPose Somewhere(const Box& box, sim::Rng* rng) {
  return {rng->Uniform(box.x0 + 0.18, box.x1 - 0.18), rng->Uniform(box.y0 + 0.18, box.y1 - 0.18),
          rng->Uniform(-sim::kPi, sim::kPi)};
}

double Shared(const DepthThumbnail& a, const sim::PlanarPose& at_a, const DepthThumbnail& b,
              const sim::PlanarPose& at_b) {
  return Covisibility(a, b, sim::Compose(sim::Inverse(at_a), at_b));
}

/// Depth alone takes both sides of a wall that is thinner than its tolerance for one.
TEST(Covisibility, TheOtherSideOfAThinWallIsAnotherPlace) {
  EXPECT_EQ(Covisibility(WallAhead(2.0f), WallAhead(2.0f), {4.1, 0.0, sim::kPi}), 0.0);
  const Box here = {0.0, 4.0, 0.0, 3.0};
  const Box beside = {4.08, 8.0, 0.0, 3.0, here.up, here.down};
  sim::Rng rng(3, "thin wall");
  double most = 0.0;
  double most_by_depth = 0.0;
  for (int i = 0; i < 100; ++i) {
    sim::PlanarPose at_a = Somewhere(here, &rng);
    sim::PlanarPose at_b = Somewhere(beside, &rng);
    if (i % 2 == 0) {  // both look at the wall
      at_a.yaw = rng.Uniform(-0.5, 0.5);
      at_b.yaw = sim::kPi + rng.Uniform(-0.5, 0.5);
    }
    DepthThumbnail a = Inside(here, at_a);
    DepthThumbnail b = Inside(beside, at_b);
    most = std::max(most, Shared(a, at_a, b, at_b));
    for (DepthThumbnail* one : {&a, &b}) {
      one->facing.assign(one->facing.size(), Eigen::Vector3f::Zero());
    }
    most_by_depth = std::max(most_by_depth, Shared(a, at_a, b, at_b));
  }
  EXPECT_GT(most_by_depth, 0.3) << "none is taken for a loop";
  EXPECT_LT(most, 0.1);
}

/// In a room without furniture both cameras are in front of all that they see.
TEST(Covisibility, WhereSurfacesFaceChangesNothingInOneRoom) {
  const Box room = {0.0, 5.0, 0.0, 3.0};
  sim::Rng rng(4, "one room");
  for (int i = 0; i < 100; ++i) {
    const sim::PlanarPose at_a = Somewhere(room, &rng);
    const sim::PlanarPose at_b = Somewhere(room, &rng);
    DepthThumbnail a = Inside(room, at_a);
    DepthThumbnail b = Inside(room, at_b);
    const double shared = Shared(a, at_a, b, at_b);
    for (DepthThumbnail* one : {&a, &b}) {
      one->facing.assign(one->facing.size(), Eigen::Vector3f::Zero());
    }
    // But for a point at an edge, say.
    EXPECT_NEAR(shared, Shared(a, at_a, b, at_b), 0.01) << i;
  }
}

/// A camera that looks up, down or is held askew, some way over the ground.
CameraTilt Tilt(double pitch, double roll, double height) {
  const Eigen::AngleAxisd up(pitch, -Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd askew(roll, Eigen::Vector3d::UnitX());
  return {(up * askew).toRotationMatrix(), height};
}

/// What it sees from a place inside; the box is measured from the height of level cameras.
DepthThumbnail InsideTilted(const Box& box, const sim::PlanarPose& pose, const CameraTilt& tilt) {
  DepthPicture picture{320, 240, {}};
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()) * tilt.level_from_camera;
  const Eigen::Vector3d low(box.x0 - pose.x, box.y0 - pose.y, -box.down - tilt.height);
  const Eigen::Vector3d high(box.x1 - pose.x, box.y1 - pose.y, box.up - tilt.height);
  for (int row = 0; row < picture.height; ++row) {
    for (int col = 0; col < picture.width; ++col) {
      const Eigen::Vector3d ray = turn * Eigen::Vector3d(1.0, -(col - kCamera.cx) / kCamera.fx,
                                                         -(row - kCamera.cy) / kCamera.fy);
      const Eigen::Array3d ways = (ray.array() > 0.0).select(high, low).array() / ray.array();
      picture.metres.push_back(static_cast<float>(ways.minCoeff()));
    }
  }
  DepthThumbnail seen = Coarsened(picture, kCamera);
  seen.tilt = tilt;
  return seen;
}

/// By hand: of a picture's tangents +-1 and +-.75 those stay that are within them after a turn up
/// by 30 degrees: .555 of all.
TEST(Covisibility, ACameraThatLooksUpSeesTheUpperPart) {
  const Box room = {-3.0, 3.0, -2.5, 2.5};
  const DepthThumbnail level = InsideTilted(room, {}, Tilt(0.0, 0.0, 0.0));
  const DepthThumbnail up = InsideTilted(room, {}, Tilt(sim::kPi / 6.0, 0.0, 0.0));
  EXPECT_NEAR(ShareSeen(level, up, {}), 0.555, 0.04);
  const DepthThumbnail down = InsideTilted(room, {}, Tilt(-sim::kPi / 6.0, 0.0, 0.0));
  EXPECT_NEAR(ShareSeen(level, down, {}), 0.555, 0.04);
  EXPECT_LT(Covisibility(up, down, {}), 0.35);
}

/// A wall 3 m ahead of which 4.5 m are seen: 1 m higher 3.5 m of them are.
TEST(Covisibility, AHigherCameraSeesLessOfTheSame) {
  DepthThumbnail low = WallAhead(3.0f);
  DepthThumbnail high = low;
  high.tilt = Tilt(0.0, 0.0, 1.0);
  EXPECT_NEAR(ShareSeen(low, high, {}), 3.5 / 4.5, 0.06);
  low.tilt = Tilt(0.0, 0.0, 1.0);
  EXPECT_DOUBLE_EQ(ShareSeen(low, high, {}), 1.0);
}

/// Wherever both cameras stand: a tilt that says level changes nothing, and a picture that is
/// turned upside down shows the same.
TEST(Covisibility, UpsideDownShowsTheSame) {
  const Box room = {0.0, 5.0, 0.0, 3.0};
  sim::Rng rng(7, "tilted");
  for (int i = 0; i < 40; ++i) {
    const sim::PlanarPose at_a = Somewhere(room, &rng);
    const sim::PlanarPose at_b = Somewhere(room, &rng);
    const double level = Shared(Inside(room, at_a), at_a, Inside(room, at_b), at_b);
    for (const double roll : {0.0, sim::kPi}) {
      const CameraTilt tilt = Tilt(0.0, roll, 0.0);
      const DepthThumbnail a = InsideTilted(room, at_a, tilt);
      EXPECT_NEAR(Shared(a, at_a, Inside(room, at_b), at_b), level, 0.1) << i;
    }
  }
}

/// The same room as a panorama of 128 x 512 shows it.
DepthThumbnail Around(const Box& box, const sim::PlanarPose& pose) {
  const agent::PanoramaLens lens = agent::PanoramaLens::Of(128, 512);
  DepthPicture picture{512, 128, {}};
  for (int row = 0; row < picture.height; ++row) {
    for (int col = 0; col < picture.width; ++col) {
      const Eigen::Vector3d ray = lens.PointAt({double(col), double(row), 1.0});
      const double x = std::cos(pose.yaw) * ray.x() - std::sin(pose.yaw) * ray.y();
      const double y = std::sin(pose.yaw) * ray.x() + std::cos(pose.yaw) * ray.y();
      const double along_x = (x > 0.0 ? box.x1 - pose.x : box.x0 - pose.x) / x;
      const double along_y = (y > 0.0 ? box.y1 - pose.y : box.y0 - pose.y) / y;
      const double upright = (ray.z() > 0.0 ? box.up : -box.down) / ray.z();
      picture.metres.push_back(static_cast<float>(std::min({along_x, along_y, upright})));
    }
  }
  return Coarsened(picture, lens);
}

TEST(Covisibility, PanoramasOfARoomSeeAllOfItFromAnywhere) {
  const Box room = {0.0, 4.0, 0.0, 3.0};
  sim::Rng rng(5, "panoramas");
  for (int i = 0; i < 40; ++i) {
    const sim::PlanarPose at_a = Somewhere(room, &rng);
    const sim::PlanarPose turned = {at_a.x, at_a.y, at_a.yaw + rng.Uniform(-3.0, 3.0)};
    EXPECT_GT(Shared(Around(room, at_a), at_a, Around(room, turned), turned), 0.93) << i;
    const sim::PlanarPose at_b = Somewhere(room, &rng);
    EXPECT_GT(Shared(Around(room, at_a), at_a, Around(room, at_b), at_b), 0.6) << i;
  }
}

TEST(Covisibility, PanoramasDoNotSeeThroughThinWalls) {
  const Box here = {0.0, 4.0, 0.0, 3.0};
  const Box beside = {4.08, 8.0, 0.0, 3.0, here.up, here.down};
  sim::Rng rng(6, "panoramas");
  for (int i = 0; i < 40; ++i) {
    const sim::PlanarPose at_a = Somewhere(here, &rng);
    const sim::PlanarPose at_b = Somewhere(beside, &rng);
    EXPECT_LT(Shared(Around(here, at_a), at_a, Around(beside, at_b), at_b), 0.25) << i;
  }
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
