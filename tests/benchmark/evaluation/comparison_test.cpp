// SPDX-License-Identifier: MIT
#include "benchmark/evaluation/comparison.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The first `successes` of 20 episodes succeed with SPL 0.5.
std::vector<EpisodeResult> MakeRun(const std::string& agent, int successes, int episodes = 20) {
  std::vector<EpisodeResult> results;
  for (int i = 0; i < episodes; ++i) {
    EpisodeResult result;
    result.key = {agent, "rgbd", "noise", 0, "house.glb", std::to_string(i)};
    result.difficulty = i % 2 == 0 ? Difficulty::kEasy : Difficulty::kHard;
    result.goals.resize(1);
    result.goals[0].success = i < successes;
    result.goals[0].spl = i < successes ? 0.5 : 0.0;
    results.push_back(result);
  }
  return results;
}

TEST(CompareRuns, PairsEpisodesOfOneAgent) {
  const Comparison comparison = CompareRuns(MakeRun("x", 4), MakeRun("x", 14), std::nullopt);
  ASSERT_EQ(comparison.rows.size(), 3u);
  EXPECT_EQ(comparison.rows[0].difficulty, "easy");
  const ComparisonRow& all = comparison.rows[2];
  EXPECT_EQ(all.difficulty, "overall");
  EXPECT_DOUBLE_EQ(all.success_a, 0.2);
  EXPECT_DOUBLE_EQ(all.success_b, 0.7);
  EXPECT_DOUBLE_EQ(all.success.mean, 0.5);
  EXPECT_DOUBLE_EQ(all.spl.mean, 0.25);
  EXPECT_EQ(all.success.pairs, 20);
  EXPECT_EQ(all.success.better, 10);
  EXPECT_TRUE(all.success.significant());
  EXPECT_EQ(comparison.only_a + comparison.only_b, 0);
}

TEST(CompareRuns, OrderOfResultsDoesNotMatter) {
  auto a = MakeRun("x", 4);
  const auto b = MakeRun("x", 14);
  const std::string text = ToText(CompareRuns(a, b, std::nullopt));
  std::reverse(a.begin(), a.end());
  EXPECT_EQ(ToText(CompareRuns(a, b, std::nullopt)), text);
}

TEST(CompareRuns, PairsTwoAgentsByName) {
  auto run = MakeRun("x", 4);
  const auto other = MakeRun("y", 14);
  run.insert(run.end(), other.begin(), other.end());
  const Comparison comparison = CompareRuns(run, run, std::pair{"y", "x"});
  EXPECT_DOUBLE_EQ(comparison.rows[2].success.mean, -0.5);
  EXPECT_THAT(ToText(comparison), HasSubstr("y -> x, rgbd, noise"));
}

TEST(CompareRuns, LeavesOutWhatHasNoPartnerAndSaysSo) {
  const Comparison comparison = CompareRuns(MakeRun("x", 4), MakeRun("x", 4, 12), std::nullopt);
  EXPECT_EQ(comparison.rows[2].success.pairs, 12);
  EXPECT_EQ(comparison.only_a, 8);
  EXPECT_EQ(comparison.only_b, 0);
  EXPECT_THAT(ToText(comparison), HasSubstr("8 results of the first"));
}

TEST(CompareRuns, ListsTheAgentsIfNoneAreShared) {
  try {
    CompareRuns(MakeRun("x", 4), MakeRun("y", 4), std::nullopt);
    ADD_FAILURE();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(),
                AllOf(HasSubstr("one has x"), HasSubstr("the other y"), HasSubstr("--agents")));
  }
}

}  // namespace
}  // namespace bulletnav::bench
