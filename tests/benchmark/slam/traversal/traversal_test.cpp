// SPDX-License-Identifier: MIT
#include "benchmark/slam/traversal/traversal.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/slam/io/file_frames.h"
#include "benchmark/slam/traversal/route.h"
#include "benchmark/slam/traversal/tum_recorder.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::HasSubstr;

TraversalSpec SmallSpec() {
  TraversalSpec spec;
  spec.camera.rows = 24;
  spec.camera.cols = 32;
  spec.actions = 60;
  return spec;
}

std::shared_ptr<const sim::World> Room() {
  return sim::World::FromMesh(tests::BoxRoom(8, 2.6f, 6), "room");
}

std::vector<TraversalFrame> Frames(const TraversalSpec& spec) {
  std::vector<TraversalFrame> frames;
  Traverse(Room(), spec, [&](const TraversalFrame& frame) {
    frames.push_back(frame);
  });
  return frames;
}

TEST(Traversal, OdometryWithoutNoiseIsTheTruth) {
  TraversalSpec spec = SmallSpec();
  spec.noise = sim::NoiseMode::kNone;
  const auto frames = Frames(spec);
  ASSERT_EQ(frames.size(), 61u);
  const auto flat = [](const TraversalFrame& frame) {
    return PlanarFromFile(CameraInFile(frame.true_pose, 1.0));
  };
  double moved = 0.0;
  for (const TraversalFrame& frame : frames) {
    const sim::PlanarPose guess = sim::Compose(flat(frames[0]), frame.dead_reckoned);
    EXPECT_NEAR(guess.x, flat(frame).x, 1e-3) << frame.step;
    EXPECT_NEAR(guess.y, flat(frame).y, 1e-3) << frame.step;
    EXPECT_NEAR(sim::WrapAngle(guess.yaw - flat(frame).yaw), 0.0, 1e-6) << frame.step;
    moved = std::max(moved, std::hypot(frame.dead_reckoned.x, frame.dead_reckoned.y));
  }
  EXPECT_GT(moved, 1.0);
}

TEST(Traversal, NoiseDriftsAndFollowsTheSeed) {
  const auto frames = Frames(SmallSpec());
  const auto again = Frames(SmallSpec());
  TraversalSpec other = SmallSpec();
  other.seed = 2;
  const auto& last = frames.back().dead_reckoned;
  EXPECT_EQ(last.x, again.back().dead_reckoned.x);
  EXPECT_EQ(frames.back().color.pixels, again.back().color.pixels);
  EXPECT_NE(last.x, Frames(other).back().dead_reckoned.x);
  const auto first = PlanarFromFile(CameraInFile(frames[0].true_pose, 1.0));
  const auto truth = PlanarFromFile(CameraInFile(frames.back().true_pose, 1.0));
  const auto guess = sim::Compose(first, last);
  EXPECT_GT(std::hypot(guess.x - truth.x, guess.y - truth.y), 1e-3);
}

TEST(Traversal, SensorNoiseIsInPicturesAloneAndTheTruthIsKept) {
  const auto clean = Frames(SmallSpec());
  TraversalSpec spec = SmallSpec();
  spec.sensor_noise = "depth_camera";
  const auto noisy = Frames(spec);
  const auto again = Frames(spec);
  ASSERT_EQ(noisy.size(), clean.size());
  int other_depths = 0;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    EXPECT_TRUE(clean[i].true_depth.metres.empty());
    EXPECT_EQ(noisy[i].true_depth.metres, clean[i].depth.metres) << i;
    EXPECT_EQ(noisy[i].depth.metres, again[i].depth.metres) << i;
    EXPECT_EQ(noisy[i].color.pixels, again[i].color.pixels) << i;
    EXPECT_EQ(noisy[i].dead_reckoned.x, clean[i].dead_reckoned.x) << i;
    if (noisy[i].depth.metres != clean[i].depth.metres) ++other_depths;
  }
  EXPECT_GT(other_depths, 50);
  spec.sensor_noise = "fog";
  EXPECT_THROW(spec.Validate(), sim::Error);
}

/// The room with a box in one of two corners.
std::shared_ptr<const sim::World> RoomWithBox(double x) {
  sim::SceneMesh mesh = tests::BoxRoom(8, 2.6f, 6);
  const auto left = static_cast<float>(x);
  tests::AddBox({left, 0, -4.5f}, {left + 2.5f, 1.5f, -1.5f}, {90, 90, 90}, &mesh);
  return sim::World::FromMesh(mesh, "room");
}

bool IsInBox(const TraversalFrame& frame, double x) {
  const Eigen::Vector3d& at = frame.true_pose.position;
  return at.x() > x && at.x() < x + 2.5 && at.z() > -4.5 && at.z() < -1.5;
}

TEST(Traversal, GoesOnWhereFurnitureHasMoved) {
  TraversalSpec spec = SmallSpec();
  spec.actions = 400;
  const auto before = RoomWithBox(0.8);
  const ChangedScene changed{RoomWithBox(4.7), 200, true};
  std::vector<TraversalFrame> plain;
  Traverse(before, spec, [&](const TraversalFrame& frame) {
    plain.push_back(frame);
  });
  std::vector<TraversalFrame> frames;
  Traverse(before, changed, spec, [&](const TraversalFrame& frame) {
    frames.push_back(frame);
  });
  ASSERT_EQ(frames.size(), 401u);
  int among_old = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i < 200) {
      EXPECT_EQ(frames[i].color.pixels, plain[i].color.pixels) << i;
    } else if (i > 260) {
      EXPECT_FALSE(IsInBox(frames[i], 4.7)) << i;
      if (IsInBox(frames[i], 0.8)) ++among_old;
    }
    if (i == 0) continue;
    const Eigen::Vector3d step = frames[i].true_pose.position - frames[i - 1].true_pose.position;
    EXPECT_LT(step.norm(), 0.4) << i;
    const auto& a = frames[i - 1].dead_reckoned;
    const auto& b = frames[i].dead_reckoned;
    EXPECT_LT(std::hypot(b.x - a.x, b.y - a.y), 0.4) << i;
  }
  EXPECT_GT(among_old, 0) << "it goes where the furniture was";
}

TEST(Traversal, NoRoomAmongMovedFurnitureIsTold) {
  sim::SceneMesh full = tests::BoxRoom(8, 2.6f, 6);
  tests::AddBox({0, 0, -6}, {7.9f, 1.5f, 0}, {90, 90, 90}, &full);
  tests::AddQuad({20, 0, 0}, {24, 0, 0}, {24, 0, -4}, {20, 0, -4}, {90, 90, 90}, &full);
  const ChangedScene changed{sim::World::FromMesh(full, "full"), 30, true};
  EXPECT_THAT(
      [&] {
        Traverse(Room(), changed, SmallSpec(), [](const TraversalFrame&) {});
      },
      testing::ThrowsMessage<sim::Error>(HasSubstr("no room")));
}

TEST(Traversal, DepthIsAlongTheAxis) {
  const sim::PinholeSpec camera = SmallSpec().camera;
  const Intrinsics k = IntrinsicsOf(camera);
  EXPECT_DOUBLE_EQ(k.fx, 16.0);
  EXPECT_DOUBLE_EQ(k.cx, 15.5);
  std::vector<float> ranges(camera.pixels(), camera.max_depth_m);
  ranges[0] = 3.0f;
  const DepthPicture depth = AlongAxis(ranges, camera);
  // The corner's ray leaves through (-15.5, -11.5) of a picture 16 pixels ahead.
  EXPECT_NEAR(depth.metres[0], 3.0 * 16.0 / std::sqrt(15.5 * 15.5 + 11.5 * 11.5 + 256.0), 1e-6);
  EXPECT_EQ(depth.metres[1], 0.0f);
}

TEST(Traversal, RoutesComeBack) {
  const auto world = Room();
  const sim::NavmeshQuery query(world->navmesh());
  Route route(query, {1, 0, -1}, sim::Rng(1, "test"));
  const auto places = route.places();
  ASSERT_GE(places.size(), 3u);
  for (const auto& place : places) EXPECT_EQ(route.Next(), place);
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    EXPECT_EQ(route.Next(), *place);
  }
}

TEST(TumRecorder, WritesWhatIsRead) {
  const tests::TemporaryFolder folder;
  TraversalSpec spec = SmallSpec();
  spec.actions = 5;
  TumRecorder recorder(folder.path() / "run", spec);
  std::vector<TraversalFrame> frames;
  Traverse(Room(), spec, [&](const TraversalFrame& frame) {
    recorder.Add(frame);
    frames.push_back(frame);
  });
  EXPECT_THROW(ReadTumFolder(folder.path() / "run", {}), sim::FileError);
  recorder.Finish();
  const TumFolder read = ReadTumFolder(folder.path() / "run", {});
  ASSERT_EQ(read.frames.size(), 6u);
  EXPECT_DOUBLE_EQ(read.intrinsics.fx, 16.0);
  const sim::Image color = sim::DecodeImage(sim::ReadFile(read.frames[5].color));
  EXPECT_EQ(color.at(3, 2)[1], frames[5].color.at(3, 2)[1]);
  const DepthPicture depth = ReadTumDepth(read.frames[5].depth);
  EXPECT_NEAR(depth.metres[40], frames[5].depth.metres[40], 1e-4);
  const auto pose = BodyFromFile(read.truth[5].pose, spec.body.camera_height);
  EXPECT_NEAR((pose.position - frames[5].true_pose.position).norm(), 0.0, 1e-6);
  EXPECT_EQ(ReadTumTrajectory(folder.path() / "run" / "odometry.txt").size(), 6u);
  EXPECT_THROW(TumRecorder(folder.path() / "run", spec), sim::FileError);
}

TEST(Traversal, RefusesBadSpecs) {
  TraversalSpec tilted = SmallSpec();
  tilted.camera.pitch_deg = -10.0;
  EXPECT_THROW(Frames(tilted), sim::Error);
  TraversalSpec none = SmallSpec();
  none.actions = 0;
  EXPECT_THROW(Frames(none), sim::Error);
}

/// The same way, and other colours from a frame on.
TEST(Traversal, ALookMayChangeOnTheWay) {
  sim::SceneMesh painted = tests::BoxRoom(8, 2.6f, 6);
  for (sim::Material& material : painted.materials) material.base_color = {90, 40, 40};
  const auto later = sim::World::FromMesh(painted, "room");
  const TraversalSpec spec = SmallSpec();
  const auto plain = Frames(spec);
  std::vector<TraversalFrame> frames;
  Traverse(Room(), {later, 30}, spec, [&](const TraversalFrame& frame) {
    frames.push_back(frame);
  });
  ASSERT_EQ(frames.size(), plain.size());
  int differ = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].true_pose.position, plain[i].true_pose.position) << i;
    EXPECT_EQ(frames[i].dead_reckoned.x, plain[i].dead_reckoned.x) << i;
    if (i < 30) {
      EXPECT_EQ(frames[i].color.pixels, plain[i].color.pixels) << i;
    }
    if (frames[i].color.pixels != plain[i].color.pixels) ++differ;
  }
  EXPECT_EQ(differ, 31);
  const auto other = sim::World::FromMesh(tests::BoxRoom(4, 2.6f, 3), "room");
  EXPECT_ANY_THROW(Traverse(Room(), {other, 30}, spec, [](const TraversalFrame&) {}));
}

}  // namespace
}  // namespace bulletnav::bench
