// SPDX-License-Identifier: MIT
#include "benchmark/report/plot_choice.h"

#include <string>

#include <gmock/gmock.h>

#include "benchmark/play/trajectory.h"
#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

EpisodeResult Of(const std::string& agent, const std::string& scene, int number, double soft_spl) {
  EpisodeResult result;
  result.key.agent = agent;
  result.key.scene = scene;
  result.key.episode = std::to_string(number);
  result.goals.resize(1);
  result.goals[0] = {{"success", 0.0}, {"soft_spl", soft_spl}};
  return result;
}

/// "AGENT/SCENE-NUMBER".
std::vector<std::string> Names(const std::vector<EpisodeResult>& chosen) {
  std::vector<std::string> names;
  for (const EpisodeResult& one : chosen) {
    names.push_back(one.key.agent + "/" + one.key.scene + "-" + one.key.episode);
  }
  return names;
}

/// Four equally bad episodes of each of two agents in two scenes, and one that is worse.
std::vector<EpisodeResult> Equals() {
  std::vector<EpisodeResult> all;
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

TEST(PlotChoice, IsAmongTheResultsWithATrajectory) {
  const tests::TemporaryFolder folder;
  EXPECT_THROW(ResultsWithTrajectory(folder.path()), sim::FileError);
  const std::vector<EpisodeResult> results = {Of("b", "s", 0, 0), Of("a", "s", 1, 0),
                                              Of("a", "s", 0, 0)};
  std::string lines;
  for (const EpisodeResult& result : results) lines += ToJsonLine(result) + "\n";
  folder.Write("episodes.jsonl", lines);
  EXPECT_THAT(ResultsWithTrajectory(folder.path()), IsEmpty());
  for (const std::size_t i : {0u, 1u}) {
    const auto file = TrajectoryPath(folder.path(), results[i].key);
    folder.Write(std::filesystem::relative(file, folder.path()).string(), "{}");
  }
  EXPECT_THAT(Names(ResultsWithTrajectory(folder.path())), ElementsAre("a/s-1", "b/s-0"));
}

}  // namespace
}  // namespace bulletnav::bench
