// SPDX-License-Identifier: MIT
#include "benchmark/runs/comparison.h"

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
    result.goals[0]["success"] = i < successes;
    result.goals[0]["start_distance"] = 0.0;
    result.goals[0]["spl"] = i < successes ? 0.5 : 0.0;
    results.push_back(result);
  }
  return results;
}

TEST(CompareRuns, PairsEpisodesOfOneAgent) {
  const Comparison comparison = CompareRuns(MakeRun("x", 4), MakeRun("x", 14), {});
  ASSERT_EQ(comparison.rows.size(), 3u);
  EXPECT_EQ(comparison.rows[0].difficulty, "easy");
  const ComparisonRow& all = comparison.rows[2];
  EXPECT_EQ(all.difficulty, "overall");
  EXPECT_DOUBLE_EQ(all.measures[0].a, 0.2);
  EXPECT_DOUBLE_EQ(all.measures[0].b, 0.7);
  EXPECT_DOUBLE_EQ(all.measures[0].difference.mean, 0.5);
  EXPECT_DOUBLE_EQ(all.measures[1].difference.mean, 0.25);
  EXPECT_EQ(all.measures[0].difference.pairs, 20);
  EXPECT_EQ(all.measures[0].difference.better, 10);
  EXPECT_TRUE(all.measures[0].difference.significant());
  EXPECT_EQ(comparison.only_a + comparison.only_b, 0);
}

TEST(CompareRuns, OrderOfResultsDoesNotMatter) {
  auto a = MakeRun("x", 4);
  const auto b = MakeRun("x", 14);
  const std::string text = ToText(CompareRuns(a, b, {}));
  std::reverse(a.begin(), a.end());
  EXPECT_EQ(ToText(CompareRuns(a, b, {})), text);
}

TEST(CompareRuns, PairsTwoAgentsByName) {
  auto run = MakeRun("x", 4);
  const auto other = MakeRun("y", 14);
  run.insert(run.end(), other.begin(), other.end());
  Pairing pairing;
  pairing.agents = {"y", "x"};
  const Comparison comparison = CompareRuns(run, run, pairing);
  EXPECT_DOUBLE_EQ(comparison.rows[2].measures[0].difference.mean, -0.5);
  EXPECT_THAT(ToText(comparison), HasSubstr("y -> x, rgbd, noise"));
}

TEST(CompareWithAll, PairsOneAgentWithEachOther) {
  auto run = MakeRun("x", 4);
  for (const auto& other : {MakeRun("y", 14), MakeRun("z", 4)}) {
    run.insert(run.end(), other.begin(), other.end());
  }
  const Comparison comparison = CompareWithAll(run, run, "y", {});
  ASSERT_EQ(comparison.rows.size(), 6u);
  EXPECT_EQ(comparison.rows[2].agent_b, "x");
  EXPECT_DOUBLE_EQ(comparison.rows[2].measures[0].difference.mean, -0.5);
  EXPECT_EQ(comparison.rows[5].agent_b, "z");
  EXPECT_EQ(comparison.only_a + comparison.only_b, 0);
  const std::string page = ToMarkdown(comparison);
  EXPECT_THAT(page,
              HasSubstr("| y -> z | rgbd, noise | overall, 20 pairs | 0.70 to 0.20 | -0.500 ["));
  EXPECT_THAT(
      [&] {
        CompareWithAll(run, run, "w", {});
      },
      testing::ThrowsMessage<sim::Error>(testing::HasSubstr("has no agent 'w'; it has ")));
  EXPECT_THROW(CompareWithAll(MakeRun("x", 4), MakeRun("x", 4), "x", {}), sim::Error);
}

TEST(CompareRuns, LeavesOutWhatHasNoPartnerAndSaysSo) {
  const Comparison comparison = CompareRuns(MakeRun("x", 4), MakeRun("x", 4, 12), {});
  EXPECT_EQ(comparison.rows[2].measures[0].difference.pairs, 12);
  EXPECT_EQ(comparison.only_a, 8);
  EXPECT_EQ(comparison.only_b, 0);
  EXPECT_THAT(ToText(comparison), HasSubstr("8 results of the first"));
}

TEST(CompareRuns, ListsTheAgentsIfNoneAreShared) {
  try {
    CompareRuns(MakeRun("x", 4), MakeRun("y", 4), {});
    ADD_FAILURE();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("one has x (rgbd, noise);"), HasSubstr("the other y ("),
                                HasSubstr("--agents")));
  }
}

TEST(CompareRuns, PairsTwoConditions) {
  const auto noise = MakeRun("x", 4);
  auto exact = MakeRun("x", 14);
  for (EpisodeResult& result : exact) result.key.condition = "no_noise";
  EXPECT_THROW(CompareRuns(noise, exact, {}), sim::Error);
  Pairing pairing;
  pairing.conditions = {"noise", "no_noise"};
  const Comparison comparison = CompareRuns(noise, exact, pairing);
  EXPECT_DOUBLE_EQ(comparison.rows[2].measures[0].difference.mean, 0.5);
  EXPECT_THAT(ToText(comparison), HasSubstr("x, rgbd, noise -> no_noise\n"));
}

TEST(CompareRuns, RefusesOtherEpisodesOfTheSameName) {
  auto other = MakeRun("x", 14);
  other[3].goals[0]["start_distance"] = 1.5;
  try {
    CompareRuns(MakeRun("x", 4), other, {});
    ADD_FAILURE();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(),
                AllOf(HasSubstr("different episodes: '3' in house.glb"), HasSubstr("1.500 m")));
  }
}

TEST(CompareRuns, SmallPValuesAreNotNone) {
  const std::string text = ToText(CompareRuns(MakeRun("x", 0), MakeRun("x", 20), {}));
  EXPECT_THAT(text, HasSubstr("p < 0.001"));
}

}  // namespace
}  // namespace bulletnav::bench
