// SPDX-License-Identifier: MIT
#include "benchmark/report/replay.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/simulator.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/trajectories.h"

namespace bulletnav::bench {
namespace {

constexpr sim::PanoramaSpec kSmall = {.rows = 16, .cols = 64};

std::shared_ptr<const sim::World> Corridor() {
  return sim::World::FromMesh(tests::LCorridor(8, 7, 1.2f, 2.6f), "corridor");
}

/// A noisy walk around the corner, read back from its file.
EpisodeTrajectory NoisyWalk(const std::shared_ptr<const sim::World>& world) {
  sim::Rng rng(4, "walk");
  const tests::Trial trial = tests::DrawTrial(world, 5.0, 9.0, &rng);
  const auto recorded =
      tests::RecordPrivileged(world, trial, "shortest_path", sim::NoiseMode::kAnsReleased);
  const tests::TemporaryFolder folder;
  return ReadTrajectory(folder.Write("walk.json", ToJson(recorded)));
}

TEST(Replay, ShowsWhatTheSimulatorShowed) {
  const auto world = Corridor();
  const EpisodeTrajectory walk = NoisyWalk(world);
  ASSERT_GT(walk.steps.size(), 20u);
  sim::SimulatorSpec spec;
  spec.panorama = kSmall;
  spec.noise = walk.noise;
  sim::Simulator simulator(world, spec);
  const sim::Observation* seen = &simulator.Reset(walk.start, walk.key);
  std::vector<std::vector<std::uint8_t>> colors = {seen->color};
  for (std::size_t i = 0; i < 20; ++i) {
    seen = &simulator.Step(walk.steps[i].action);
    colors.push_back(seen->color);
  }
  const std::vector<int> steps = {0, 7, 7, 20};
  const auto pictures = ReplayPanoramas(world, walk, kSmall, steps);
  ASSERT_EQ(pictures.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(pictures[i].pixels, colors[static_cast<std::size_t>(steps[i])]) << steps[i];
  }
}

TEST(Replay, WholeEpisodeKeepsToTheRecord) {
  const auto world = Corridor();
  const EpisodeTrajectory walk = NoisyWalk(world);
  const std::vector<int> last = {static_cast<int>(walk.steps.size())};
  EXPECT_NO_THROW(ReplayPanoramas(world, walk, kSmall, last));
}

TEST(Replay, AnotherNoiseIsNoticed) {
  const auto world = Corridor();
  EpisodeTrajectory walk = NoisyWalk(world);
  ++walk.key.episode;
  const std::vector<int> last = {static_cast<int>(walk.steps.size())};
  EXPECT_THROW(ReplayPanoramas(world, walk, kSmall, last), sim::Error);
}

TEST(Replay, AgentsWalkTheSameUnderTheRecorder) {
  const auto world = Corridor();
  sim::Rng rng(4, "walk");
  const tests::Trial trial = tests::DrawTrial(world, 2.0, 9.0, &rng);
  const auto noise = sim::NoiseMode::kAnsReleased;
  const auto one = tests::RecordAgent(world, trial, "random", noise);
  EXPECT_EQ(ToJson(one), ToJson(tests::RecordAgent(world, trial, "random", noise)));
  EXPECT_EQ(one.result.goals[0].Whole("steps") + 1, static_cast<int>(one.steps.size()));
}

}  // namespace
}  // namespace bulletnav::bench
