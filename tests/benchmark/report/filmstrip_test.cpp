// SPDX-License-Identifier: MIT
#include "benchmark/report/filmstrip.h"

#include <gmock/gmock.h>

#include "tests/support/scenes.h"
#include "tests/support/trajectories.h"

namespace bulletnav::bench {
namespace {

using testing::ElementsAre;

TEST(Filmstrip, FramesAreSpreadFromTheFirstStepToTheLast) {
  EXPECT_THAT(FilmSteps(100, 5), ElementsAre(0, 25, 50, 75, 100));
  EXPECT_THAT(FilmSteps(7, 3), ElementsAre(0, 4, 7));
  EXPECT_THAT(FilmSteps(2, 7), ElementsAre(0, 1, 2));
  EXPECT_THAT(FilmSteps(0, 7), ElementsAre(0));
}

TEST(Filmstrip, KnowsThePresentGoal) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  EXPECT_EQ(GoalAt(trajectory, trajectory.steps.size()), 0u) << "also after the stop there";
  trajectory.steps.resize(5);
  trajectory.steps[1].action = sim::Action::kStop;
  trajectory.goals.resize(3, trajectory.goals[0]);
  trajectory.result.goals.assign(3, GoalMetrics{{"success", 0.0}, {"steps", 0.0}});
  trajectory.result.goals[0]["steps"] = 1;
  trajectory.result.goals[1]["steps"] = 3;
  EXPECT_EQ(GoalAt(trajectory, 0), 0u);
  EXPECT_EQ(GoalAt(trajectory, 1), 0u);
  EXPECT_EQ(GoalAt(trajectory, 2), 1u) << "the stop ended the first";
  EXPECT_EQ(GoalAt(trajectory, 5), 1u) << "nobody set out for the third";
}

TEST(Filmstrip, ShowsTheGoalThenTheFramesTheSameEachTime) {
  const sim::SceneMesh mesh = tests::BoxRoom(6, 2.6f, 6);
  const auto world = sim::World::FromMesh(mesh, "room");
  sim::Rng rng(1, "film");
  const tests::Trial trial = tests::DrawTrial(world, 2.0, 4.0, &rng);
  const auto trajectory =
      tests::RecordPrivileged(world, trial, "shortest_path", sim::NoiseMode::kAnsReleased);
  const SceneMap map = MakeSceneMap(mesh, world->navmesh(), {});
  FilmstripSpec spec;
  spec.panorama.rows = 16;
  spec.panorama.cols = 64;
  spec.frames = 3;
  const auto draw = [&] {
    return ToImage(Filmstrip(world, map, trajectory, spec), 1.0);
  };
  const sim::Image film = draw();
  EXPECT_EQ(draw().pixels, film.pixels);
  // Down the first column the goal and the start, down the next two frames.
  for (const auto& [x, y] : {std::pair{200, 80}, {200, 190}, {600, 80}, {600, 190}}) {
    const std::uint8_t* p = film.at(x, y);
    EXPECT_LT(p[0] + p[1] + p[2], 3 * 250) << x << " " << y;
  }
}

}  // namespace
}  // namespace bulletnav::bench
