// SPDX-License-Identifier: MIT
#include "benchmark/privileged/oracle_semantic_model.h"

#include <cmath>

#include <gtest/gtest.h>

#include "agent/perception/relative_pose.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

using agent::kDirections;

/// A room 8 x 8 m with a wall across its middle, at z = -4, from x = 0 to 5; the body looks at it.
class OracleSemanticModelTest : public testing::Test {
 protected:
  OracleSemanticModelTest() {
    sim::SceneMesh mesh = tests::BoxRoom(8, 2.6f, 8);
    tests::AddBox({0, 0, -4.1f}, {5, 2.6f, -4.0f}, {9, 9, 9}, &mesh);
    truth_.world = sim::World::FromMesh(mesh, "room");
    truth_.pose = {{3.5, 0, -2}, 0.0};
    truth_.goal_panorama.depth = goal_depth_;
  }

  agent::PanoramaCode Here() { return model_.Encode(std::array{agent::Panorama{}}).front(); }
  agent::PairPrediction ToGoal(const Eigen::Vector3d& goal) {
    truth_.goal.position = goal;
    const agent::PanoramaCode source = Here();
    const std::array sources = {&source};
    return model_.Compare(sources, model_.Encode(std::array{truth_.goal_panorama}).front()).front();
  }

  std::vector<float> goal_depth_ = {1.0f};
  GroundTruth truth_;
  OracleSemanticModel model_{truth_};
};

TEST_F(OracleSemanticModelTest, TellsWhereAGoalOfTheNodeIs) {
  for (const double bearing : {0.1, 1.0, -1.0, 2.5, -2.9}) {
    const sim::BodyPose goal = sim::Apply(truth_.pose, {std::cos(bearing), std::sin(bearing), 0.0});
    const agent::PairPrediction view = ToGoal(goal.position);
    EXPECT_EQ(view.same_node, 1.0f);
    EXPECT_NEAR(agent::RelativePoseOf(view).distance, 1.0, 1e-5);
    EXPECT_NEAR(agent::RelativePoseOf(view).bearing, bearing, 1e-5);
    float sum = 0.0f;
    for (const float p : view.direction) sum += p;
    EXPECT_NEAR(sum, 1.0f, 1e-6f);
  }
}

TEST_F(OracleSemanticModelTest, ScoresDirectionsByTheWayFromTheFarthestFreePlace) {
  const agent::PairPrediction view = ToGoal({1.0, 0, -7.0});
  EXPECT_EQ(view.same_node, 0.0f);
  const auto way = [](double x, double z, double gx, double gz) {
    return std::hypot(x - gx, z - gz);
  };
  // To the right, 3 m, is round the end of the wall at x = 5.1.
  const double right = way(6.5, -2.0, 5.1, -4.1) + way(5.1, -4.1, 1.0, -7.0);
  EXPECT_NEAR(view.score[9], 1.0 - right / 20.0, 0.02);
  // Ahead the way ends at the wall, some 1.8 m off.
  const double ahead = way(3.5, -3.75, 5.1, -3.9) + way(5.1, -3.9, 1.0, -7.0);
  EXPECT_NEAR(view.score[0], 1.0 - ahead / 20.0, 0.02);
  EXPECT_GT(view.score[10], view.score[3]);
}

TEST_F(OracleSemanticModelTest, ExplorableIsWhatIsFreeForThreeMetres) {
  const auto open = model_.Explorable(Here());
  EXPECT_EQ(open[0], 0.0f);  // the wall
  EXPECT_EQ(open[3], 1.0f);  // left, 3.5 m to the wall of the room
  EXPECT_EQ(open[9], 1.0f);  // right
  EXPECT_EQ(open[6], 0.0f);  // behind, 2 m to the wall
  truth_.pose.yaw = sim::kPi / 2;
  EXPECT_EQ(model_.Explorable(Here())[0], 1.0f);
}

TEST_F(OracleSemanticModelTest, CodesStayWhereTheyWereTaken) {
  const agent::PanoramaCode before = Here();
  truth_.pose.position.x() += 1.0;
  const std::array sources = {&before};
  const agent::PairPrediction view = model_.Compare(sources, Here()).front();
  EXPECT_NEAR(view.distance, 1.0, 1e-5);
  EXPECT_EQ(view.direction[9], 1.0f);
}

}  // namespace
}  // namespace bulletnav::bench
