// SPDX-License-Identifier: MIT
// Places in which agents once stood or paced until their time was up.
#include <array>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tests/support/trials.h"

namespace bulletnav::agent {
namespace {

constexpr sim::Rgb8 kGrey = {128, 128, 128};

sim::SimulatorSpec Quiet() {
  sim::SimulatorSpec spec;
  spec.noise = sim::NoiseMode::kNone;
  spec.color = false;
  return spec;
}

/// Active Neural SLAM with goals at random, which need no trained policy.
tests::TrialResult Play(const sim::SceneMesh& mesh, const tests::Trial& trial,
                        const std::string& agent) {
  const auto world = sim::World::FromMesh(mesh, "place");
  sim::Simulator simulator(world, Quiet());
  const AgentMaker maker =
      agent == "active_neural_slam"
          ? ConfigureAgent(agent, sim::ParseYaml("random_goal: true", "stuck_test"))
          : ConfigureAgent(agent);
  return tests::RunTrial(&simulator, trial, maker);
}

/// Walls of a place x in [0, width], z in [-depth, 0] from `low` to 2.6 m.
void AddWalls(float width, float depth, float low, sim::SceneMesh* mesh) {
  const std::array<Eigen::Vector3f, 4> corners = {
      {{0, low, 0}, {width, low, 0}, {width, low, -depth}, {0, low, -depth}}};
  const Eigen::Vector3f up(0, 2.6f - low, 0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3f& a = corners[i];
    const Eigen::Vector3f& b = corners[(i + 1) % corners.size()];
    tests::AddQuad(b, a, a + up, b + up, kGrey, mesh);
  }
}

void AddFloor(float x0, float x1, float z0, float z1, float height, sim::SceneMesh* mesh) {
  tests::AddQuad({x0, height, z0}, {x1, height, z0}, {x1, height, z1}, {x0, height, z1}, kGrey,
                 mesh);
}

/// A hall around a stairwell without a rail, x in [3, 7], z in [-5, -1.5], whose floor is a storey
/// below.
sim::SceneMesh Stairwell() {
  sim::SceneMesh mesh;
  AddFloor(0, 3, 0, -7, 0, &mesh);
  AddFloor(7, 10, 0, -7, 0, &mesh);
  AddFloor(3, 7, 0, -1.5f, 0, &mesh);
  AddFloor(3, 7, -5, -7, 0, &mesh);
  AddFloor(3, 7, -1.5f, -5, -2.8f, &mesh);
  AddWalls(10, 7, -2.8f, &mesh);
  return mesh;
}

/// A room whose wall ahead, at z = -6, is missing: there the floor ends over nothing, and so does
/// everything. The goal is behind a wall at x = 5, which leaves a way at its near end.
sim::SceneMesh Exit() {
  sim::SceneMesh mesh;
  AddFloor(0, 9, 0, -6, 0, &mesh);
  const Eigen::Vector3f up(0, 2.6f, 0);
  const std::array<Eigen::Vector3f, 4> outline = {{{0, 0, -6}, {0, 0, 0}, {9, 0, 0}, {9, 0, -6}}};
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    tests::AddQuad(outline[i], outline[i + 1], outline[i + 1] + up, outline[i] + up, kGrey, &mesh);
  }
  tests::AddBox({5, 0, -6}, {5.2f, 2.6f, -1.2f}, kGrey, &mesh);
  return mesh;
}

/// A shop with a counter from wall to nearly the other wall, over which one sees.
sim::SceneMesh Counter() {
  sim::SceneMesh mesh = tests::BoxRoom(10, 2.6f, 8);
  tests::AddBox({0, 0, -4.3f}, {8.8f, 1.1f, -3.7f}, kGrey, &mesh);
  return mesh;
}

class Stuck : public testing::TestWithParam<const char*> {};

TEST_P(Stuck, WalksRoundAStairwellWithoutPushingAtItsEdge) {
  const tests::Trial trial{{{1, 0, -3}, 0.0}, {{9, 0, -3}, 0.0}, 10.0, {}};
  const tests::TrialResult result = Play(Stairwell(), trial, GetParam());
  EXPECT_TRUE(result.success()) << result.steps;
  EXPECT_LE(result.collisions, 6);
}

TEST_P(Stuck, DoesNotPushAtAnExitOverNothing) {
  const tests::Trial trial{{{2, 0, -3}, 0.0}, {{8, 0, -5}, 0.0}, 10.0, {}};
  const tests::TrialResult result = Play(Exit(), trial, GetParam());
  EXPECT_TRUE(result.success()) << result.steps;
  EXPECT_LE(result.collisions, 6);
}

TEST_P(Stuck, GoesRoundACounterToAGoalBehindIt) {
  if (std::string(GetParam()) == "nts_paper") GTEST_SKIP() << "it stops by the straight distance";
  const tests::Trial trial{{{1, 0, -2.7}, 0.0}, {{1, 0, -5.3}, 0.0}, 17.0, {}};
  const tests::TrialResult result = Play(Counter(), trial, GetParam());
  EXPECT_TRUE(result.success()) << result.steps;
  EXPECT_LT(result.path_length, 40.0);
}

INSTANTIATE_TEST_SUITE_P(Agents, Stuck,
                         testing::Values("nts", "nts_paper", "metric_map_fbe",
                                         "active_neural_slam"));

}  // namespace
}  // namespace bulletnav::agent
