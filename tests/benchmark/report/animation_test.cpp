// SPDX-License-Identifier: MIT
#include "benchmark/report/animation.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tests/support/trajectories.h"

namespace bulletnav::bench {
namespace {

TEST(EpisodeAnimationTest, GrowsThePathAndAsksForBeliefsInOrder) {
  const sim::SceneMesh mesh = tests::BoxRoom(6, 2.6f, 6);
  const auto world = sim::World::FromMesh(mesh, "room");
  sim::Rng rng(1, "animation");
  const tests::Trial trial = tests::DrawTrial(world, 2.0, 4.0, &rng);
  const auto trajectory =
      tests::RecordPrivileged(world, trial, "shortest_path", sim::NoiseMode::kAnsReleased);
  const SceneMap map = MakeSceneMap(mesh, world->navmesh(), {});
  std::vector<std::size_t> asked;
  AnimationSpec spec;
  spec.panorama.rows = 16;
  spec.panorama.cols = 64;
  spec.frames = 5;
  spec.belief = [&](std::size_t action) {
    asked.push_back(action);
    return agent::Belief();
  };
  const auto frames = EpisodeAnimation(world, map, trajectory, spec);
  ASSERT_EQ(frames.size(), 5u);
  EXPECT_EQ(asked.size(), frames.size());
  EXPECT_TRUE(std::is_sorted(asked.begin(), asked.end()));
  EXPECT_LT(asked.back(), trajectory.steps.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].milliseconds, i + 1 < frames.size() ? spec.frame_ms : spec.last_ms);
    EXPECT_EQ(frames[i].image.width, frames[0].image.width);
    if (i > 0) EXPECT_NE(frames[i].image.pixels, frames[i - 1].image.pixels);
  }
  const auto again = EpisodeAnimation(world, map, trajectory, spec);
  EXPECT_EQ(again[2].image.pixels, frames[2].image.pixels);
}

}  // namespace
}  // namespace bulletnav::bench
