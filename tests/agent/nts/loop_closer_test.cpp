// SPDX-License-Identifier: MIT
#include "agent/nts/loop_closer.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "agent/mapping/metric_map.h"
#include "agent/perception/relative_pose.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

using sim::DegToRad;
using sim::PlanarPose;

/// What F_L and F_R say of one pose from another, if they are right.
PairPrediction Seen(const PlanarPose& from, const PlanarPose& to, double certainty = 0.999) {
  PairPrediction p;
  p.same_node = static_cast<float>(certainty);
  p.distance = static_cast<float>(std::hypot(to.x - from.x, to.y - from.y));
  const double bearing = sim::WrapAngle(std::atan2(to.y - from.y, to.x - from.x) - from.yaw);
  // The line between two directions, as RelativePoseOf reads it, is within a degree or two.
  const int nearest = DirectionOf(bearing);
  p.direction[static_cast<std::size_t>(nearest)] = 1.0f;
  return p;
}

/// A body that walks around a square of 6 m and whose odometry turns it too far to the left.
class LoopCloserTest : public testing::Test {
 protected:
  void Step(const PlanarPose& by) {
    truth_ = Compose(truth_, by);
    odometry_ = Compose(odometry_, {by.x, by.y, by.yaw * (1.0 + too_far_)});
    closer_.Move(odometry_);
  }
  void Side() {
    for (int i = 0; i < 24; ++i) Step({0.25, 0.0, 0.0});
    for (int i = 0; i < 9; ++i) Step({0.0, 0.0, DegToRad(10.0)});
  }
  void MakeNode() {
    closer_.AddNode();
    nodes_.push_back(truth_);
  }
  LoopCloser::Sight SightOf(int node, double certainty = 0.999) const {
    const PlanarPose& at = nodes_[static_cast<std::size_t>(node)];
    return {node, Seen(at, truth_, certainty), Seen(truth_, at, certainty)};
  }
  /// Where a node is as seen from the body.
  PlanarPose FromBody(const PlanarPose& body, const PlanarPose& node) const {
    return Compose(Inverse(body), node);
  }

  LoopCloser closer_{{.close = true}};
  double too_far_ = 0.03;
  PlanarPose truth_;
  PlanarPose odometry_;
  std::vector<PlanarPose> nodes_;
};

TEST_F(LoopCloserTest, ANodeKnownAgainMovesTowardsWhereItIsSeen) {
  MakeNode();
  for (int i = 0; i < 3; ++i) {
    Side();
    MakeNode();
  }
  for (int i = 0; i < 20; ++i) Step({0.25, 0.0, 0.0});  // 1 m short of the first node
  const PlanarPose true_first = FromBody(truth_, nodes_[0]);
  const PlanarPose first_before = FromBody(odometry_, {});
  ASSERT_TRUE(closer_.IsDue());
  ASSERT_TRUE(closer_.IsOld(0));
  const auto poses = closer_.Close(std::array{SightOf(0)});
  ASSERT_TRUE(poses);
  ASSERT_EQ(poses->size(), 4u);
  const PlanarPose first = FromBody(odometry_, (*poses)[0]);
  const double before = Distance({first_before.x, first_before.y}, {true_first.x, true_first.y});
  EXPECT_GT(before, 0.4);
  EXPECT_LT(Distance({first.x, first.y}, {true_first.x, true_first.y}), 0.85 * before)
      << "one sight counts for no more than it is sure";
  // The last node is where odometry has it, nearly.
  const PlanarPose last = FromBody(odometry_, (*poses)[3]);
  const PlanarPose true_last = FromBody(truth_, nodes_[3]);
  EXPECT_LT(Distance({last.x, last.y}, {true_last.x, true_last.y}), 0.15);
}

TEST_F(LoopCloserTest, ManyRoundsDoNotTurnTheGraph) {
  too_far_ = 0.02;
  MakeNode();
  for (int i = 0; i < 3; ++i) {
    Side();
    MakeNode();
  }
  Side();
  std::vector<PlanarPose> at = nodes_;
  for (int round = 0; round < 40; ++round) {
    const int node = round % 4;
    for (int i = 0; i < 4; ++i) Step({0.25, 0.0, 0.0});
    const auto poses = closer_.Close(std::array{SightOf(node)});
    ASSERT_TRUE(poses);
    at = *poses;
    for (int i = 0; i < 20; ++i) Step({0.25, 0.0, 0.0});
    for (int i = 0; i < 9; ++i) Step({0.0, 0.0, DegToRad(10.0)});
  }
  // 73 degrees by the odometry.
  EXPECT_GT(std::fabs(sim::WrapAngle(odometry_.yaw - truth_.yaw)), 1.0);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const PlanarPose seen = FromBody(odometry_, at[i]);
    const PlanarPose is = FromBody(truth_, nodes_[i]);
    EXPECT_LT(Distance({seen.x, seen.y}, {is.x, is.y}), 1.0) << i;
  }
}

TEST_F(LoopCloserTest, WhatIsUncertainOrDisagreesMovesNothing) {
  MakeNode();
  for (int i = 0; i < 3; ++i) Side();
  for (int i = 0; i < 20; ++i) Step({0.25, 0.0, 0.0});
  EXPECT_FALSE(closer_.Close({}));
  EXPECT_FALSE(closer_.Close(std::array{SightOf(0, 0.98)}));
  LoopCloser::Sight one_way = SightOf(0);
  one_way.of_node.same_node = 0.5f;
  EXPECT_FALSE(closer_.Close(std::array{one_way}));
  LoopCloser::Sight two_places = SightOf(0);
  two_places.of_node.distance += 1.0f;
  EXPECT_FALSE(closer_.Close(std::array{two_places}));
}

TEST_F(LoopCloserTest, ItAsksAfterSomeWayAndForNodesOfLongAgo) {
  EXPECT_FALSE(closer_.IsDue()) << "no nodes";
  MakeNode();
  EXPECT_FALSE(closer_.IsDue());
  for (int i = 0; i < 4; ++i) Step({0.25, 0.0, 0.0});
  EXPECT_TRUE(closer_.IsDue());
  EXPECT_FALSE(closer_.IsOld(0));
  for (int i = 0; i < 36; ++i) Step({0.25, 0.0, 0.0});
  EXPECT_TRUE(closer_.IsOld(0));
  EXPECT_TRUE(closer_.Close(std::array{SightOf(0)}));
  EXPECT_FALSE(closer_.IsOld(0));
  EXPECT_FALSE(closer_.IsDue());
  LoopCloser off({.close = false});
  off.AddNode();
  off.Move({5.0, 0.0, 0.0});
  EXPECT_FALSE(off.IsDue());
}

TEST_F(LoopCloserTest, ResetForgets) {
  MakeNode();
  for (int i = 0; i < 44; ++i) Step({0.25, 0.0, 0.0});
  closer_.Reset();
  EXPECT_FALSE(closer_.IsDue());
  truth_ = odometry_ = {};
  nodes_.clear();
  MakeNode();
  EXPECT_FALSE(closer_.IsOld(0));
}

TEST(LoopSpec, RefusesWhatMakesNoSense) {
  EXPECT_NO_THROW(LoopSpec{}.Validate());
  EXPECT_THROW((LoopSpec{.certainty = 1.0}.Validate()), sim::Error);
  EXPECT_THROW((LoopSpec{.least_way = -1.0}.Validate()), sim::Error);
  EXPECT_THROW((LoopSpec{.apart = 0.0}.Validate()), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
