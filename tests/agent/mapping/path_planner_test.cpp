// SPDX-License-Identifier: MIT
#include "agent/mapping/path_planner.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::agent {
namespace {

/// The L-shaped corridor seen from a place 1 m along it, heading along it, and its plane: x ahead.
/// Outline in the plane: x from -1 to 5, y from -0.75 to 0.75 and on from x = 3.5 to y = 4.25.
MetricMap Corridor() {
  Rig rig;
  MapSpec spec;
  spec.vision = 6.0;
  spec.clearance_cells = 0;  // plain lengths
  const auto scene =
      sim::MakeRenderScene(tests::LCorridor(6, 5, 1.5f, 2.6f), sim::Backend::kEmbree);
  MetricMap map(rig, spec);
  for (const sim::PlanarPose& pose : {sim::PlanarPose{0, 0, 0}, sim::PlanarPose{4.2, 0, 0}}) {
    const sim::BodyPose body = sim::Apply({{1, 0, -0.75}, -sim::kPi / 2}, pose);
    const Eigen::Vector3d eye = body.position + Eigen::Vector3d(0, rig.camera_height, 0);
    const auto seen = tests::RenderPanorama(*scene, rig.panorama,
                                            {eye.cast<float>(), static_cast<float>(body.yaw)});
    map.Update({{}, seen.depth}, pose);
  }
  return map;
}

TEST(PathPlanner, MeasuresTheWayRoundTheCorner) {
  const MetricMap map = Corridor();
  PathPlanner planner({}, 0.25);
  const auto plan = planner.Plan(map, {{0, 0}, {4.25, 3.5}});
  ASSERT_TRUE(plan);
  // The inner corner, which the dilation moves a little.
  const double truth = std::hypot(3.5, 0.75) + std::hypot(0.75, 2.75);
  EXPECT_NEAR(plan->distance, truth, 0.03 * truth + 0.1);
  EXPECT_NEAR(Distance(plan->point, {0, 0}), 0.25, 0.06);
  EXPECT_NEAR(std::atan2(plan->point.y, plan->point.x), std::atan2(0.75, 3.5), 0.2);
}

TEST(PathPlanner, FollowedStepByStepItArrivesOnTheShortestWay) {
  const MetricMap map = Corridor();
  PathPlanner planner({}, 0.25);
  Point at{0, 0};
  const Point goal{4.25, 3.5};
  double walked = 0.0;
  for (int i = 0; i < 60 && Distance(at, goal) > 0.05; ++i) {
    const auto plan = planner.Plan(map, {at, goal});
    ASSERT_TRUE(plan);
    walked += Distance(at, plan->point);
    at = plan->point;
    ASSERT_NE(map.states()[map.CellAt(at)], sim::CellState::kBlocked);
  }
  EXPECT_LT(Distance(at, goal), 0.05);
  EXPECT_LT(walked, 1.06 * (std::hypot(3.5, 0.75) + std::hypot(0.75, 2.75)));
}

TEST(PathPlanner, FindsNoWayThroughUnknownCellsUnlessAllowed) {
  const MetricMap map = Corridor();
  PathPlanner planner({}, 0.25);
  const Point outside{0.0, 3.0};
  EXPECT_FALSE(planner.Plan(map, {{0, 0}, outside}));
  EXPECT_FALSE(planner.Plan(map, {{0, 0}, {100.0, 0.0}, true})) << "not even on the map";
}

TEST(PathPlanner, ANearFreeCellStandsInForAGoalInsideAWall) {
  const MetricMap map = Corridor();
  PathPlanner planner({}, 0.25);
  const auto plan = planner.Plan(map, {{0, 0}, {2.0, 0.76}});
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan->distance, std::hypot(2.0, 0.76), 0.2);
}

TEST(PathPlanner, ANearGoalIsItsOwnWaypoint) {
  const MetricMap map = Corridor();
  PathPlanner planner({}, 0.25);
  const auto plan = planner.Plan(map, {{0, 0}, {0.1, -0.1}});
  ASSERT_TRUE(plan);
  EXPECT_LT(Distance(plan->point, {0.1, -0.1}), 0.05);
  EXPECT_TRUE(planner.Plan(map, {{0, 0}, {0, 0}}));
}

}  // namespace
}  // namespace bulletnav::agent
