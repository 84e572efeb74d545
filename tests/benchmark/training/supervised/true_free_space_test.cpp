// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/true_free_space.h"

#include <cmath>

#include <gtest/gtest.h>

#include "agent/mapping/metric_map.h"
#include "tests/support/houses.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

using agent::FreeSpace;
using sim::Cell;

std::vector<float> DepthAt(const sim::RenderScene& scene, const sim::BodyPose& pose) {
  const agent::Rig rig;
  const Eigen::Vector3d eye = pose.position + Eigen::Vector3d(0, rig.camera_height, 0);
  return tests::RenderPanorama(scene, rig.panorama,
                               {eye.cast<float>(), static_cast<float>(pose.yaw)})
      .depth;
}

TEST(TrueFreeSpace, ShowsTheWallsOfABoxRoomWhereTheyAre) {
  const auto scene = sim::MakeRenderScene(tests::BoxRoom(4, 2.6f, 5), sim::Backend::kEmbree);
  // Looks along -z from (1.5, 0, -2): walls are 3 m ahead, 1.5 m left, 2 m behind, 2.5 m right.
  TrueFreeSpace truth(agent::Rig{});
  const auto depth = DepthAt(*scene, {{1.5, 0, -2}, 0.0});
  const FreeSpace space = truth.Predict({{}, depth});
  int obstacles = 0;
  for (std::size_t i = 0; i < space.explored.values().size(); ++i) {
    const FreeSpace::Place p = FreeSpace::CentreOf(space.explored.cell(i));
    const double out =
        std::max({p.x - 3.0, -2.0 - p.x, p.y - 1.5, -2.5 - p.y});  // through the nearest wall
    if (space.obstacle[i] > 0.5f) {
      EXPECT_LT(std::fabs(out), 0.051) << p.x << " " << p.y;
      EXPECT_EQ(space.explored[i], 1.0f);
      ++obstacles;
    }
    if (out > 0.06) {
      EXPECT_EQ(space.explored[i], 0.0f) << p.x << " " << p.y;
    }
    if (out < -0.06 && std::hypot(p.x, p.y) < 3.1) {
      EXPECT_EQ(space.explored[i], 1.0f) << p.x << " " << p.y;
    }
  }
  EXPECT_GT(obstacles, 200);
}

/// Shares of cells within 3 m of the body on which two maps agree.
struct Agreement {
  double explored = 0.0;
  double obstacle_found = 0.0;  // obstacles of the first with one of the second on or beside them
  double obstacle_true = 0.0;   // and the other way round
};

bool HasNear(const agent::MetricMap& map, const sim::Cell& cell) {
  for (int k = 0; k < 9; ++k) {
    if (map.IsObstacle({cell.x + k % 3 - 1, cell.y + k / 3 - 1})) return true;
  }
  return false;
}

double FoundIn(const agent::MetricMap& other, const agent::MetricMap& map,
               const sim::Cell& middle) {
  double found = 0.0;
  double all = 0.0;
  for (int i = 0; i < 121 * 121; ++i) {
    const sim::Cell cell{middle.x + i % 121 - 60, middle.y + i / 121 - 60};
    if (!map.IsObstacle(cell) || Distance(cell, middle) > 60) continue;
    all += 1.0;
    found += HasNear(other, cell) ? 1.0 : 0.0;
  }
  return found / all;
}

Agreement Compare(const agent::MetricMap& a, const agent::MetricMap& b, const sim::Cell& middle) {
  double same = 0.0;
  double all = 0.0;
  for (int i = 0; i < 121 * 121; ++i) {
    const sim::Cell cell{middle.x + i % 121 - 60, middle.y + i / 121 - 60};
    if (Distance(cell, middle) > 60) continue;
    all += 1.0;
    same += a.IsExplored(cell) == b.IsExplored(cell) ? 1.0 : 0.0;
  }
  return {same / all, FoundIn(b, a, middle), FoundIn(a, b, middle)};
}

TEST(TrueFreeSpace, AMapByAPerfectMapperIsNearlyTheMapByDepth) {
  const auto scene = sim::MakeRenderScene(tests::ShellHouse(3), sim::Backend::kEmbree);
  agent::Rig blind;
  blind.has_depth = false;
  // A walk through the house's middle, turning on the way; walls may be walked through here.
  for (const sim::PlanarPose& pose :
       {sim::PlanarPose{0.0, 0.0, 0.0}, sim::PlanarPose{0.73, 0.21, 0.9},
        sim::PlanarPose{1.4, -0.6, -2.2}}) {
    const auto depth = DepthAt(*scene, sim::Apply({{3, 0, -3}, 0.0}, pose));
    agent::MetricMap by_depth(agent::Rig{}, {});
    agent::MetricMap by_mapper(blind, {}, std::make_shared<TrueFreeSpace>(agent::Rig{}));
    by_depth.Update({{}, depth}, pose);
    by_mapper.Update({{}, depth}, pose);
    const Agreement agreement = Compare(by_depth, by_mapper, by_depth.CellAt({pose.x, pose.y}));
    EXPECT_GT(agreement.explored, 0.97);
    EXPECT_GT(agreement.obstacle_found, 0.98);
    EXPECT_GT(agreement.obstacle_true, 0.98);
  }
}

}  // namespace
}  // namespace bulletnav::bench
