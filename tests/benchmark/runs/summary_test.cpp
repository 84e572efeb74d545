// SPDX-License-Identifier: MIT
#include "benchmark/runs/summary.h"

#include <algorithm>
#include <limits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "benchmark/runs/published.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

EpisodeResult Result(const std::string& agent, Difficulty difficulty, int episode, bool success,
                     double spl) {
  EpisodeResult result;
  result.key = {agent,       "rgbd",
                "noise",     0,
                "house.glb", std::string(DifficultyName(difficulty)) + std::to_string(episode)};
  result.difficulty = difficulty;
  GoalMetrics metrics;
  metrics["success"] = success;
  metrics["success_euclidean"] = success;
  metrics["spl"] = spl;
  metrics["soft_spl"] = spl / 2;
  metrics["distance_to_goal"] = success ? 0.25 : std::numeric_limits<double>::infinity();
  metrics["euclidean_distance"] = success ? 0.125 : 4.0;
  metrics["steps"] = 10 * (episode + 1);
  metrics["collisions"] = episode;
  result.goals = {metrics};
  return result;
}

std::vector<EpisodeResult> SomeResults() {
  std::vector<EpisodeResult> results;
  for (const char* agent : {"nts", "alpha"}) {
    for (int i = 0; i < 4; ++i) {
      results.push_back(Result(agent, Difficulty::kEasy, i, i > 0, i > 0 ? 0.8 : 0.0));
      results.push_back(Result(agent, Difficulty::kHard, i, i > 2, i > 2 ? 0.4 : 0.0));
    }
  }
  return results;
}

const SummaryRow& Find(const std::vector<SummaryRow>& rows, const std::string& agent,
                       const std::string& difficulty) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const SummaryRow& row) {
    return row.agent == agent && row.difficulty == difficulty;
  });
  EXPECT_NE(found, rows.end());
  return *found;
}

TEST(Summarize, MeansByHand) {
  const std::vector<AgentRow> agents = {{"nts", "", {{"rgbd", 25'000'000}, {"rgb", 3}}, "oracle"}};
  const auto rows = Summarize(SomeResults(), agents);
  ASSERT_EQ(rows.size(), 6u);
  const SummaryRow& easy = Find(rows, "nts", "easy");
  EXPECT_EQ(easy.episodes, 4);
  EXPECT_DOUBLE_EQ(*easy.Of("success").mean, 0.75);
  EXPECT_EQ(easy.Of("success").interval, WilsonInterval(3, 4));
  EXPECT_DOUBLE_EQ(*easy.Of("spl").mean, 0.6);
  EXPECT_DOUBLE_EQ(*easy.Of("soft_spl").mean, 0.3);
  EXPECT_DOUBLE_EQ(*easy.Of("steps").mean, 25.0);
  EXPECT_DOUBLE_EQ(*easy.Of("collisions").mean, 1.5);
  EXPECT_EQ(easy.frames_trained, 25'000'000);
  EXPECT_EQ(easy.note, "oracle");
  EXPECT_DOUBLE_EQ(*easy.Of("distance_to_goal").mean, (4.0 + 3 * 0.25) / 4);
  EXPECT_EQ(easy.Of("success").paper, 0.87);
  EXPECT_EQ(easy.Of("spl").paper, 0.65);
  const SummaryRow& overall = Find(rows, "nts", "overall");
  EXPECT_EQ(overall.episodes, 8);
  EXPECT_DOUBLE_EQ(*overall.Of("success").mean, 0.5);
  EXPECT_DOUBLE_EQ(*overall.Of("spl").mean, 0.35);
  EXPECT_EQ(Find(rows, "alpha", "hard").Of("success").paper, std::nullopt);
  EXPECT_EQ(Find(rows, "alpha", "hard").frames_trained, std::nullopt);
}

TEST(Summarize, OrderOfResultsDoesNotMatter) {
  std::vector<EpisodeResult> results = SomeResults();
  sim::Rng rng(1, "values");
  for (EpisodeResult& result : results) result.goals[0]["spl"] = rng.Uniform();
  const std::string one = SummaryToJson(Summarize(results, {}));
  rng.Shuffle(results);
  EXPECT_EQ(SummaryToJson(Summarize(results, {})), one);
}

TEST(Summarize, ListedAgentsComeFirst) {
  const std::vector<AgentRow> agents = {{"nts", "", {}, ""}};
  EXPECT_EQ(Summarize(SomeResults(), agents).front().agent, "nts");
  EXPECT_EQ(Summarize(SomeResults(), {}).front().agent, "alpha");
  EXPECT_TRUE(Summarize({}, agents).empty());
}

TEST(Summarize, SequencesByNumberOfGoals) {
  std::vector<EpisodeResult> results = {Result("nts", Difficulty::kEasy, 0, true, 0.5),
                                        Result("nts", Difficulty::kEasy, 1, false, 0.0)};
  for (EpisodeResult& result : results) {
    result.difficulty.reset();
    result.goals.push_back(result.goals[0]);
    result.goals.back()["success"] = true;
    result.goals.back()["spl"] = 1.0;
  }
  const auto rows = Summarize(results, {});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_DOUBLE_EQ(*Find(rows, "nts", "goals_1").Of("success").mean, 0.5);
  EXPECT_DOUBLE_EQ(*Find(rows, "nts", "goals_2").Of("success").mean, 0.75);
  EXPECT_DOUBLE_EQ(*Find(rows, "nts", "goals_2").Of("spl").mean, 0.625);
  EXPECT_DOUBLE_EQ(*Find(rows, "nts", "goals_2").Of("steps").mean, 30.0);
  EXPECT_DOUBLE_EQ(*Find(rows, "nts", "overall").Of("success").mean, 0.75);
  EXPECT_EQ(Find(rows, "nts", "overall").Of("success").paper, std::nullopt);  // of single goals
}

TEST(Summarize, AllGoalsOfASequenceAreExactlyOne) {
  EpisodeResult result = Result("nts", Difficulty::kEasy, 0, true, 1.0);
  result.goals.resize(10, result.goals[0]);
  const auto rows = Summarize({result, result}, {});
  for (const SummaryRow& row : rows) {
    EXPECT_EQ(*row.Of("success").mean, 1.0) << row.difficulty;
    EXPECT_EQ(row.Of("success").interval->high, 1.0) << row.difficulty;
    EXPECT_LE(row.Of("success").interval->low, 1.0) << row.difficulty;
    EXPECT_EQ(row.Of("spl").interval, (Interval{1.0, 1.0})) << row.difficulty;
  }
}

TEST(Summarize, JsonHasExactlyThePromisedKeys) {
  const auto json = nlohmann::ordered_json::parse(SummaryToJson(Summarize(SomeResults(), {})));
  ASSERT_EQ(json["rows"].size(), 6u);
  std::vector<std::string> keys;
  for (const auto& [key, value] : json["rows"][0].items()) keys.push_back(key);
  EXPECT_THAT(keys,
              testing::ElementsAre("agent", "setting", "condition", "difficulty", "episodes",
                                   "success", "success_ci", "success_euclidean", "spl", "spl_ci",
                                   "soft_spl", "steps_mean", "collisions_mean", "frames_trained",
                                   "paper_success", "paper_spl", "distance_to_goal_mean", "note"));
  EXPECT_EQ(json["rows"][0]["success_ci"].size(), 2u);
  EXPECT_TRUE(json["rows"][0]["frames_trained"].is_null());
}

TEST(Summarize, CsvHasAColumnForEveryValue) {
  std::vector<EpisodeResult> results = SomeResults();
  results[0].key.agent = "a, \"b\"";
  const std::string csv = SummaryToCsv(Summarize(results, {}));
  EXPECT_THAT(csv, testing::StartsWith("agent,setting,condition,difficulty,episodes,success,"
                                       "success_ci_low,success_ci_high,"));
  EXPECT_THAT(csv, testing::HasSubstr("\n\"a, \"\"b\"\"\",rgbd,noise,easy,1,0.0,"));
  const std::string plain = SummaryToCsv(Summarize(SomeResults(), {}));
  EXPECT_EQ(std::count(plain.begin(), plain.end(), '\n'), 7);
  EXPECT_EQ(std::count(plain.begin(), plain.end(), ','), 7 * 19);
}

TEST(Published, FiguresOfThePaper) {
  EXPECT_EQ(FindPublished("success", "nts", "rgb", "noise", "overall"), 0.55);
  EXPECT_EQ(FindPublished("spl", "nts", "rgb", "noise", "overall"), 0.38);
  EXPECT_EQ(FindPublished("success", "metric_map_fbe", "rgbd", "no_noise", "hard"), 0.23);
  EXPECT_EQ(FindPublished("spl", "metric_map_fbe", "rgbd", "no_noise", "hard"), std::nullopt);
  EXPECT_EQ(FindPublished("success", "metric_map_fbe", "rgb", "noise", "easy"), std::nullopt);
  EXPECT_EQ(FindPublished("success", "nts", "rgb", "no_stop", "easy"), std::nullopt);
  EXPECT_EQ(FindPublished("success", "random", "rgbd", "noise", "easy"), std::nullopt);
  EXPECT_EQ(FindPublished("success", "nts", "rgbd", "noise", "goals_1"), std::nullopt);
}

/// The paper's overall column is the mean of the three before it, to its two digits.
TEST(Published, OverallIsTheMeanOfTheDifficulties) {
  for (const char* agent : {"resnet_gru_il", "target_driven_rl", "metric_map_rl", "metric_map_fbe",
                            "active_neural_slam", "nts"}) {
    for (const char* setting : {"rgb", "rgbd"}) {
      for (const char* condition : {"noise", "no_stop", "no_noise"}) {
        const auto figure = [&](const char* measure, const char* difficulty) {
          return FindPublished(measure, agent, setting, condition, difficulty);
        };
        if (!figure("success", "easy")) continue;
        const double mean = (*figure("success", "easy") + *figure("success", "medium") +
                             *figure("success", "hard")) /
                            3;
        EXPECT_NEAR(*figure("success", "overall"), mean, 0.0101) << agent << setting << condition;
        if (!figure("spl", "easy")) continue;
        const double spl =
            (*figure("spl", "easy") + *figure("spl", "medium") + *figure("spl", "hard")) / 3;
        EXPECT_NEAR(*figure("spl", "overall"), spl, 0.0101) << agent << setting << condition;
      }
    }
  }
}

}  // namespace
}  // namespace bulletnav::bench
