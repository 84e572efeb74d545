// SPDX-License-Identifier: MIT
#include "benchmark/report/trajectory_legend.h"

#include <string>

#include <gmock/gmock.h>

#include "tests/support/scenes.h"
#include "tests/support/trajectories.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// The texts of a legend beside the room of MadeUpTrajectory.
std::vector<std::string> Texts(const EpisodeTrajectory& trajectory, bool belief) {
  const sim::SceneMesh mesh = tests::BoxRoom(4, 2.6f, 4);
  const SceneMap map = MakeSceneMap(mesh, sim::Navmesh(mesh, {}), {});
  const MapPlace place(map, {Canvas::Point(0, 0), Canvas::Point(500, 500)});
  std::vector<std::string> texts;
  for (const LegendEntry& entry : LegendOf(trajectory, place, belief)) texts.push_back(entry.text);
  return texts;
}

TEST(TrajectoryLegend, NamesAllThatThePictureShows) {
  EXPECT_THAT(Texts(tests::MadeUpTrajectory(), true),
              ElementsAre("true path", "path by odometry", "shortest path", "start", "goal",
                          "stop at the goal", "collision", "its map: free", "its map: obstacle",
                          "its map: felt wall", "its graph, ghosts, scores", "chosen path",
                          "its last target"));
  EXPECT_THAT(Texts(tests::MadeUpTrajectory(), false), Not(Contains(HasSubstr("its"))));
}

TEST(TrajectoryLegend, LeavesOutKindsThatTheMapLacks) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  auto& kinds = trajectory.belief.map->kinds;
  kinds[8] = agent::MapPicture::Kind::kUnknown;
  EXPECT_THAT(Texts(trajectory, true),
              AllOf(Contains("its map: free"), Not(Contains("its map: felt wall"))));
  std::fill(kinds.begin(), kinds.end(), agent::MapPicture::Kind::kUnknown);
  EXPECT_THAT(Texts(trajectory, true), Not(Contains(HasSubstr("its map"))));
}

TEST(TrajectoryLegend, LeavesOutWhatLiesOffThePicture) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  trajectory.belief.target->x = 50.0;
  trajectory.belief.map->low_x = 50.0;
  EXPECT_THAT(Texts(trajectory, true),
              AllOf(Not(Contains("its last target")), Not(Contains(HasSubstr("its map")))));
}

TEST(TrajectoryLegend, LeavesOutWhatTheGraphLacks) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  trajectory.belief.graph->path.clear();
  trajectory.belief.graph->nodes[2].score.reset();
  EXPECT_THAT(Texts(trajectory, true),
              AllOf(Contains("its graph, ghosts"), Not(Contains("chosen path"))));
  trajectory.belief.graph->nodes[2].is_ghost = false;
  EXPECT_THAT(Texts(trajectory, true), Contains("its graph"));
  trajectory.belief.graph = agent::GraphPicture{};
  EXPECT_THAT(Texts(trajectory, true), Not(Contains(HasSubstr("graph"))));
}

TEST(TrajectoryLegend, SpeaksOfStopsOnlyWhereTheyCount) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  trajectory.steps.pop_back();
  trajectory.result.goals[0]["success"] = false;
  EXPECT_THAT(Texts(trajectory, false), Contains("end without stop"));
  trajectory.result.key.condition = "no_stop";
  EXPECT_THAT(Texts(trajectory, false), Contains("goal not reached in time"));
  trajectory.result.failure = "threw: no map";
  EXPECT_THAT(Texts(trajectory, false), Contains("goal not reached"));
  trajectory.result = tests::MadeUpTrajectory().result;
  trajectory.result.key.condition = "no_stop";
  EXPECT_THAT(Texts(trajectory, false), Contains("goal reached"));
}

TEST(TrajectoryLegend, SaysWhereShortestPathsOfSequencesBegin) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  trajectory.goals.push_back(trajectory.start);
  EXPECT_THAT(Texts(trajectory, false), Contains("shortest path, goal to goal"));
}

TEST(TrajectoryLegend, LeavesOutAChosenPathThatTheAgentHadLeft) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  trajectory.belief.target->y += 0.5;
  EXPECT_THAT(Texts(trajectory, true),
              AllOf(Contains("its last target"), Not(Contains("chosen path"))));
}

TEST(TrajectoryLegend, LeavesOutPathsThatWereNotWalked) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  trajectory.steps.clear();
  trajectory.shortest_path.clear();
  EXPECT_THAT(Texts(trajectory, false), ElementsAre("start", "goal", testing::_));
}

}  // namespace
}  // namespace bulletnav::bench
