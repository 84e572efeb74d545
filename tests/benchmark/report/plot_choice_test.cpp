// SPDX-License-Identifier: MIT
#include "benchmark/report/plot_choice.h"

#include <string>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/trajectories.h"

namespace bulletnav::bench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// An episode "AGENT/SCENE-NUMBER".
ChosenTrajectory Of(const std::string& agent, const std::string& scene, int number,
                    double soft_spl) {
  ChosenTrajectory one;
  one.name = agent + "/" + scene + "-" + std::to_string(number);
  one.trajectory.result.key.agent = agent;
  one.trajectory.result.key.scene = scene;
  one.trajectory.result.key.episode = std::to_string(number);
  one.trajectory.result.goals.resize(1);
  one.trajectory.result.goals[0].soft_spl = soft_spl;
  return one;
}

std::vector<std::string> Names(const std::vector<ChosenTrajectory>& chosen) {
  std::vector<std::string> names;
  for (const ChosenTrajectory& one : chosen) names.push_back(one.name.string());
  return names;
}

/// Four equally bad episodes of each of two agents in two scenes, and one that is worse.
std::vector<ChosenTrajectory> Equals() {
  std::vector<ChosenTrajectory> all;
  for (const char* agent : {"a", "b"}) {
    for (const char* scene : {"s", "t"}) {
      for (const int number : {0, 1}) all.push_back(Of(agent, scene, number, 0.5));
    }
  }
  all.push_back(Of("b", "t", 2, 0.25));
  return all;
}

TEST(PlotChoice, EquallyBadEpisodesComeInTurn) {
  PlotChoice choice;
  choice.worst = 9;
  EXPECT_THAT(
      Names(Choose(Equals(), choice)),
      ElementsAre("b/t-2", "a/s-0", "b/t-0", "a/t-0", "b/s-0", "a/s-1", "b/t-1", "a/t-1", "b/s-1"));
  choice.worst = 3;
  EXPECT_THAT(Names(Choose(Equals(), choice)), ElementsAre("b/t-2", "a/s-0", "b/t-0"));
}

TEST(PlotChoice, FewEpisodesOfARowDoNotHoldUpTheOthers) {
  PlotChoice choice;
  choice.worst = 9;
  EXPECT_THAT(Names(Choose({Of("a", "s", 0, 0), Of("a", "s", 1, 0), Of("b", "t", 0, 0)}, choice)),
              ElementsAre("a/s-0", "b/t-0", "a/s-1"));
}

TEST(PlotChoice, IsByEpisodeAndAgentOrTheFirstOnes) {
  EXPECT_EQ(Choose(Equals(), {}).size(), 8u);
  EXPECT_EQ(Choose(Equals(), {.all = true}).size(), 9u);
  EXPECT_THAT(Names(Choose(Equals(), {.episode = "2"})), ElementsAre("b/t-2"));
  EXPECT_THAT(Names(Choose(Equals(), {.episode = "1", .agent = "a"})),
              ElementsAre("a/s-1", "a/t-1"));
  EXPECT_THAT(Choose(Equals(), {.agent = "c"}), IsEmpty());
}

TEST(PlotChoice, RunsWithoutTrajectoriesHaveNone) {
  const tests::TemporaryFolder folder;
  EXPECT_THAT(ReadTrajectories(folder.path()), IsEmpty());
  folder.Write("trajectories/nts/b.json", ToJson(tests::MadeUpTrajectory()));
  folder.Write("trajectories/nts/a.json", ToJson(tests::MadeUpTrajectory()));
  EXPECT_THAT(Names(ReadTrajectories(folder.path())), ElementsAre("nts/a", "nts/b"));
  folder.Write("trajectories/nts/c.json", "{");
  EXPECT_THROW(ReadTrajectories(folder.path()), sim::FileError);
}

}  // namespace
}  // namespace bulletnav::bench
