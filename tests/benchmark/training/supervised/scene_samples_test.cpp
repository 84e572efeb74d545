// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/scene_samples.h"

#include <cmath>

#include <gmock/gmock.h>

#include "benchmark/training/supervised/scene_panoramas.h"
#include "sim/base/error.h"
#include "tests/support/scenes.h"
#include "tests/support/training_scenes.h"

namespace bulletnav::bench {
namespace {

using testing::DoubleNear;

DataConfig Points(int count) {
  DataConfig config;
  config.points = count;
  return config;
}

std::shared_ptr<const sim::World> WorldOf(const sim::SceneMesh& mesh, const char* name = "a") {
  return sim::World::FromMesh(mesh, name, {{}, {}, sim::Backend::kEmbree});
}

/// Calls check(source, goal) for every ordered pair.
template <class Check>
void ForPairs(const SceneSamples& samples, const Check& check) {
  for (int s = 0; s < samples.count(); ++s) {
    for (int g = 0; g < samples.count(); ++g) check(s, g);
  }
}

/// Whether a point is in a room of this size with a margin on all sides: 1 yes, -1 no, 0 close to
/// the walls.
int Inside(const Eigen::Vector3d& p, double width, double depth, double margin) {
  const double least = std::min({p.x(), width - p.x(), -p.z(), p.z() + depth});
  return std::abs(least) < margin ? 0 : (least > 0.0 ? 1 : -1);
}

TEST(SceneSamplesTest, InABoxEverythingIsKnown) {
  const auto world = WorldOf(tests::BoxRoom(9, 2.5f, 5));
  const SceneSamples samples = MakeSceneSamples(*world, Points(25));
  for (int s = 0; s < samples.count(); ++s) {
    for (int i = 0; i < agent::kDirections; ++i) {
      const auto target = PointAlong(samples.poses[static_cast<std::size_t>(s)], i, 3.0).position;
      const int inside = Inside(target, 9, 5, 0.2);
      if (inside != 0) {
        EXPECT_EQ(samples.IsExplorable(s, i), inside > 0) << s << " " << i;
      }
      if (inside > 0) {
        EXPECT_THAT(samples.FarPoint(s, i).position.x(), DoubleNear(target.x(), 0.01));
      }
    }
  }
  ForPairs(samples, [&](int s, int g) {
    const PairLabel& label = samples.pair(s, g);
    const auto& from = samples.poses[static_cast<std::size_t>(s)];
    const auto& to = samples.poses[static_cast<std::size_t>(g)];
    const sim::PlanarPose relative = RelativePose(from, to);
    const double distance = std::hypot(relative.x, relative.y);
    EXPECT_EQ(label.same_node != 0, distance <= 3.0) << s << " " << g;
    EXPECT_THAT(double{label.distance_m()}, DoubleNear(distance, 1e-3));
    for (int i = 0; i < agent::kDirections; ++i) {
      const double straight = (samples.FarPoint(s, i).position - to.position).norm();
      EXPECT_THAT(double{label.far_score(i)}, DoubleNear(1.0 - straight / 20.0, 0.012));
    }
  });
}

TEST(SceneSamplesTest, AWallDividesNodesAndAddsTheWayThroughTheDoor) {
  const auto world = WorldOf(tests::TwoRooms());
  const SceneSamples samples = MakeSceneSamples(*world, Points(40));
  const sim::NavmeshQuery query(world->navmesh());
  int through_door = 0;
  int behind_wall = 0;
  ForPairs(samples, [&](int s, int g) {
    const PairLabel& label = samples.pair(s, g);
    const Eigen::Vector3d& a = samples.poses[static_cast<std::size_t>(s)].position;
    const Eigen::Vector3d& b = samples.poses[static_cast<std::size_t>(g)].position;
    for (int i = 0; i < agent::kDirections; ++i) {
      const double way =
          query.GeodesicDistance(samples.FarPoint(s, i).position.cast<float>(), b.cast<float>());
      EXPECT_THAT(double{label.far_score(i)}, DoubleNear(1.0 - way / 20.0, 0.015));
    }
    if ((a.x() < 4.0) == (b.x() < 4.0) || (b - a).norm() > 3.0) return;
    const double crossing = a.z() + (b.z() - a.z()) * (4.0 - a.x()) / (b.x() - a.x());
    const double off_middle = std::abs(crossing + 2.0);
    if (off_middle < 0.3) {
      ++through_door;
      EXPECT_EQ(label.same_node, 1) << a.transpose() << " to " << b.transpose();
    } else if (off_middle > 0.45 + 0.3) {
      ++behind_wall;
      EXPECT_EQ(label.same_node, 0) << a.transpose() << " to " << b.transpose();
    }
  });
  EXPECT_GT(through_door, 5);
  EXPECT_GT(behind_wall, 5);
}

TEST(SceneSamplesTest, PointsDependOnSeedAndSceneAndNumberAlone) {
  const auto mesh = tests::TwoRooms();
  const auto world = WorldOf(mesh);
  const SceneSamples few = MakeSceneSamples(*world, Points(4));
  const SceneSamples more = MakeSceneSamples(*world, Points(6));
  const SceneSamples elsewhere = MakeSceneSamples(*WorldOf(mesh, "b"), Points(4));
  DataConfig config = Points(4);
  config.seed = 1;
  const SceneSamples reseeded = MakeSceneSamples(*world, config);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(few.poses[i].position, more.poses[i].position);
    EXPECT_EQ(few.poses[i].yaw, more.poses[i].yaw);
    EXPECT_NE(few.poses[i].position, elsewhere.poses[i].position);
    EXPECT_NE(few.poses[i].position, reseeded.poses[i].position);
  }
  EXPECT_EQ(few.pair(1, 3), more.pair(1, 3));
}

TEST(SceneSamplesTest, WithoutFloorThereIsAnError) {
  sim::SceneMesh mesh;
  tests::AddBox({0, 0, 0}, {0.3f, 2, 0.3f}, {90, 90, 90}, &mesh);
  EXPECT_THROW(MakeSceneSamples(*WorldOf(mesh), Points(2)), sim::Error);
}

TEST(ScenePanoramasTest, DrawsTheSamplesThatAreAskedForInTheirOrder) {
  DataConfig config;
  config.panorama = {.rows = 16, .cols = 64};
  const auto scene = sim::MakeRenderScene(tests::BoxRoom(4, 2.5f, 4), sim::Backend::kEmbree);
  ScenePanoramas panoramas(*scene, config);
  const std::vector<sim::BodyPose> poses = {tests::StandingAt(1, -1), tests::StandingAt(2, -2),
                                            tests::StandingAt(3, -1, 90)};
  const std::size_t pixels = config.panorama.pixels();
  std::vector<std::uint8_t> color(6 * pixels);
  std::vector<float> depth(2 * pixels);
  const std::vector<int> wanted = {2, 0};
  panoramas.Render(poses, wanted, color, depth);
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<std::uint8_t> one_color(3 * pixels);
    std::vector<float> one_depth(pixels);
    panoramas.Render(poses, {&wanted[k], 1}, one_color, one_depth);
    EXPECT_TRUE(std::equal(one_color.begin(), one_color.end(),
                           color.begin() + static_cast<long>(k * 3 * pixels)));
    EXPECT_TRUE(std::equal(one_depth.begin(), one_depth.end(),
                           depth.begin() + static_cast<long>(k * pixels)));
  }
}

}  // namespace
}  // namespace bulletnav::bench
