// SPDX-License-Identifier: MIT
#include "benchmark/episodes/episode_drawer.h"

#include <array>
#include <cmath>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int kEpisodes = 20;

const Ground& Corridor() {
  static const Ground ground("corridor.glb", tests::LCorridor(10, 8, 2, 2.5f), {});
  return ground;
}

EpisodeDrawer CorridorDrawer(std::uint64_t seed = 1) {
  return {Corridor(), "scenes/corridor.glb", "corridor", {}, seed};
}

/// Length of the shortest way between points of the corridor for a body of 0.1 m radius: straight
/// or around the inner corner (8, -2).
double CorridorDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector2d corner(8, -2);
  const Eigen::Vector2d p(a.x(), a.z());
  const Eigen::Vector2d q(b.x(), b.z());
  const Eigen::Vector2d way = q - p;
  const Eigen::Vector2d to_corner = corner - p;
  // The inner corner is left of every straight way that is free, whichever end it starts from.
  const double side = way.x() * to_corner.y() - way.y() * to_corner.x();
  const bool from_first_arm = p.x() < q.x();
  const bool apart = (p.x() < 8 && q.y() < -2) || (q.x() < 8 && p.y() < -2);
  if (!apart || (from_first_arm ? side < 0 : side > 0)) return way.norm();
  return to_corner.norm() + (q - corner).norm();
}

TEST(EpisodeDrawer, DistancesLieInTheirBandsAndAreTrue) {
  EpisodeDrawer drawer = CorridorDrawer();
  for (const Difficulty difficulty :
       {Difficulty::kEasy, Difficulty::kMedium, Difficulty::kHard, Difficulty::kVeryHard}) {
    for (int i = 0; i < kEpisodes; ++i) {
      const Episode episode = drawer.Draw(difficulty, i);
      ASSERT_EQ(episode.goals.size(), 1u);
      EXPECT_EQ(episode.difficulty, difficulty);
      const double distance = episode.goals[0].geodesic_distance;
      EXPECT_TRUE(BandOf(difficulty).Holds(distance)) << distance;
      // The navmesh keeps the body's radius from the corner and rounds to its cells.
      EXPECT_NEAR(distance, CorridorDistance(episode.start_position, episode.goals[0].position),
                  0.3);
      EXPECT_NO_THROW(CheckEpisode(episode, Corridor().physics, Corridor().navmesh, {}));
    }
  }
}

TEST(EpisodeDrawer, LeavesOutTheTopsOfFurniture) {
  sim::SceneMesh mesh = tests::BoxRoom(9, 2.8f, 7);
  const Eigen::Vector3f middle = mesh.Bounds().center();
  tests::AddBox({middle.x() - 1.3f, 0.0f, middle.z() - 1.3f},
                {middle.x() + 1.3f, 0.6f, middle.z() + 1.3f}, sim::kWhite, &mesh);
  EXPECT_EQ(Ground("bed.glb", mesh, {}).navmesh.islands().size(), 1u);
  sim::NavmeshSpec all;  // the drawer leaves them out by itself, too
  all.indoor_only = false;
  const Ground ground("bed.glb", mesh, all);
  ASSERT_EQ(ground.navmesh.islands().size(), 2u);
  ASSERT_GT(ground.navmesh.islands()[1].radius, 1.5f);  // large enough to be taken for a floor
  EpisodeDrawer drawer(ground, "bed.glb", "bed", {}, 1);
  for (int i = 0; i < 60; ++i) {
    const Episode episode = drawer.Draw(Difficulty::kEasy, i);
    EXPECT_LT(episode.start_position.y(), 0.3);
    EXPECT_LT(episode.goals[0].position.y(), 0.3);
  }
}

TEST(EpisodeDrawer, LeavesOutTablesThatCanBeClimbed) {
  sim::SceneMesh mesh = tests::BoxRoom(8, 2.6f, 8);
  tests::AddBox({3, 0, -5}, {5, 0.18f, -3}, {9, 9, 9}, &mesh);
  tests::AddBox({3.4f, 0.18f, -4.6f}, {4.6f, 0.36f, -3.4f}, {9, 9, 9}, &mesh);
  const Ground ground("table.glb", mesh, {});
  ASSERT_EQ(ground.navmesh.islands().size(), 1u);
  EpisodeDrawer drawer(ground, "table.glb", "table", {}, 1);
  for (int i = 0; i < 60; ++i) {
    const Episode episode = drawer.Draw(Difficulty::kEasy, i);
    EXPECT_LT(episode.start_position.y(), 0.1) << i;
    EXPECT_LT(episode.goals[0].position.y(), 0.1) << i;
  }
}

TEST(EpisodeDrawer, NamesItsEpisodes) {
  const Episode episode = CorridorDrawer().Draw(Difficulty::kHard, 12);
  EXPECT_EQ(episode.id, "corridor-hard-0012");
  EXPECT_EQ(episode.scene, "scenes/corridor.glb");
  EXPECT_EQ(episode.goals[0].radius, 1.0);
  EXPECT_EQ(CorridorDrawer().DrawSequence(3, 4).id, "corridor-sequence-0004");
}

TEST(EpisodeDrawer, AnEpisodeDependsOnSeedKindAndIndexAlone) {
  EpisodeDrawer drawer = CorridorDrawer();
  const Episode third = drawer.Draw(Difficulty::kMedium, 3);
  drawer.Draw(Difficulty::kHard, 3);
  EXPECT_EQ(drawer.Draw(Difficulty::kMedium, 3), third);
  EXPECT_EQ(CorridorDrawer().Draw(Difficulty::kMedium, 3), third);
  EXPECT_NE(drawer.Draw(Difficulty::kMedium, 4).start_position, third.start_position);
  EXPECT_NE(CorridorDrawer(2).Draw(Difficulty::kMedium, 3).start_position, third.start_position);
  EpisodeDrawer moved(Corridor(), "/elsewhere/corridor.glb", "corridor", {}, 1);
  EXPECT_EQ(moved.Draw(Difficulty::kMedium, 3).start_position, third.start_position);
}

TEST(EpisodeDrawer, EachGoalOfASequenceIsNearTheLast) {
  EpisodeDrawer drawer = CorridorDrawer();
  for (int i = 0; i < 5; ++i) {
    const Episode episode = drawer.DrawSequence(6, i);
    EXPECT_EQ(episode.difficulty, std::nullopt);
    ASSERT_EQ(episode.goals.size(), 6u);
    Eigen::Vector3d last = episode.start_position;
    for (const EpisodeGoal& goal : episode.goals) {
      EXPECT_TRUE(kSequentialBand.Holds(goal.geodesic_distance));
      EXPECT_NEAR(goal.geodesic_distance, CorridorDistance(last, goal.position), 0.3);
      last = goal.position;
    }
    EXPECT_NO_THROW(CheckEpisode(episode, Corridor().physics, Corridor().navmesh, {}));
  }
}

TEST(EpisodeDrawer, HeadingsPointEverywhere) {
  EpisodeDrawer drawer = CorridorDrawer();
  std::array<int, 4> starts{};
  std::array<int, 4> goals{};
  for (int i = 0; i < 80; ++i) {
    const Episode episode = drawer.Draw(Difficulty::kEasy, i);
    const auto quarter = [](double yaw) {
      return static_cast<std::size_t>(std::floor((yaw + sim::kPi) / (0.5 * sim::kPi))) % 4;
    };
    ++starts[quarter(episode.start().yaw)];
    ++goals[quarter(episode.goal(0).yaw)];
  }
  EXPECT_THAT(starts, testing::Each(testing::Gt(8)));
  EXPECT_THAT(goals, testing::Each(testing::Gt(8)));
}

TEST(LeastRatio, KeepsEachRatioAsOftenAsHabitat) {
  constexpr int kDraws = 100'000;
  for (const double ratio : {1.0, 1.03, 1.06, 1.0999, 1.1, 3.0}) {
    int kept = 0;
    for (int i = 0; i < kDraws; ++i) kept += ratio >= LeastRatio((i + 0.5) / kDraws) ? 1 : 0;
    const double expected = ratio < 1.1 ? 20.0 * (ratio - 0.98) * (ratio - 0.98) : 1.0;
    EXPECT_NEAR(static_cast<double>(kept) / kDraws, expected, 1e-4) << ratio;
  }
}

/// In a room without furniture each way is straight, and episodes are kept with a probability of
/// 20 * 0.02^2; in the corridor the winding ones win.
TEST(EpisodeDrawer, PrefersWindingWays) {
  EpisodeDrawer drawer = CorridorDrawer();
  int winding = 0;
  for (int i = 0; i < kEpisodes; ++i) {
    const Episode episode = drawer.Draw(Difficulty::kHard, i);
    const double straight = (episode.start_position - episode.goals[0].position).norm();
    if (episode.goals[0].geodesic_distance > 1.1 * straight) ++winding;
  }
  EXPECT_GT(winding, kEpisodes * 3 / 4);
}

TEST(EpisodeDrawer, SaysWhichSceneIsTooSmall) {
  const Ground closet("closet.glb", tests::BoxRoom(1.2f, 2.5f, 1.2f), {});
  EXPECT_THROW(EpisodeDrawer(closet, "closet.glb", "closet", {}, 1), sim::Error);
  const Ground room("room.glb", tests::BoxRoom(3, 2.5f, 3), {});
  EpisodeDrawer drawer(room, "room.glb", "room", {}, 1);
  EXPECT_NO_THROW(drawer.Draw(Difficulty::kEasy, 0));
  try {
    drawer.Draw(Difficulty::kHard, 0);
    ADD_FAILURE();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("room.glb"), HasSubstr("hard"), HasSubstr("leave")));
  }
}

class CheckEpisodeTest : public testing::Test {
 protected:
  std::string Complaint(const Episode& episode) const {
    try {
      CheckEpisode(episode, Corridor().physics, Corridor().navmesh, {});
    } catch (const sim::Error& e) {
      return e.what();
    }
    return "nothing";
  }
  Episode episode_ = CorridorDrawer().DrawSequence(2, 0);
};

TEST_F(CheckEpisodeTest, NamesAStartInAWall) {
  episode_.start_position = {10.0, 0, -4};
  EXPECT_THAT(Complaint(episode_), AllOf(HasSubstr("corridor-sequence-0000"), HasSubstr("start:"),
                                         HasSubstr("inside a wall")));
}

TEST_F(CheckEpisodeTest, NamesAGoalOutsideTheScene) {
  episode_.goals[1].position = {100.0, 0, 0};
  EXPECT_THAT(Complaint(episode_), AllOf(HasSubstr("goal 2:"), HasSubstr("no floor")));
}

TEST(CheckEpisode, NamesAGoalOnAnotherIsland) {
  sim::SceneMesh mesh = tests::BoxRoom(4, 2.5f, 8);
  tests::AddBox({0, 0, -4.5f}, {4, 2.5f, -3.5f}, sim::kWhite, &mesh);
  const Ground ground("halves.glb", mesh, {});
  Episode episode;
  episode.id = "x";
  episode.scene = "halves.glb";
  episode.start_position = {2, 0, -1};
  episode.goals = {{{2, 0, -7}, {}, 1.0, 6.0}};
  try {
    CheckEpisode(episode, ground.physics, ground.navmesh, {});
    ADD_FAILURE();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("goal:"), HasSubstr("another island")));
  }
}

}  // namespace
}  // namespace bulletnav::bench
