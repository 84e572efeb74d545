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
  metrics.success = success;
  metrics.success_euclidean = success;
  metrics.spl = spl;
  metrics.soft_spl = spl / 2;
  metrics.distance_to_goal = success ? 0.25 : std::numeric_limits<double>::infinity();
  metrics.euclidean_distance = success ? 0.125 : 4.0;
  metrics.steps = 10 * (episode + 1);
  metrics.collisions = episode;
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
  EXPECT_DOUBLE_EQ(easy.success, 0.75);
  EXPECT_EQ(easy.success_ci, WilsonInterval(3, 4));
  EXPECT_DOUBLE_EQ(easy.spl, 0.6);
  EXPECT_DOUBLE_EQ(easy.soft_spl, 0.3);
  EXPECT_DOUBLE_EQ(easy.steps_mean, 25.0);
  EXPECT_DOUBLE_EQ(easy.collisions_mean, 1.5);
  EXPECT_EQ(easy.frames_trained, 25'000'000);
  EXPECT_EQ(easy.note, "oracle");
  EXPECT_DOUBLE_EQ(easy.distance_to_goal_mean, (4.0 + 3 * 0.25) / 4);
  EXPECT_EQ(easy.paper_success, 0.87);
  EXPECT_EQ(easy.paper_spl, 0.65);
  const SummaryRow& overall = Find(rows, "nts", "overall");
  EXPECT_EQ(overall.episodes, 8);
  EXPECT_DOUBLE_EQ(overall.success, 0.5);
  EXPECT_DOUBLE_EQ(overall.spl, 0.35);
  EXPECT_EQ(Find(rows, "alpha", "hard").paper_success, std::nullopt);
  EXPECT_EQ(Find(rows, "alpha", "hard").frames_trained, std::nullopt);
}

TEST(Summarize, OrderOfResultsDoesNotMatter) {
  std::vector<EpisodeResult> results = SomeResults();
  sim::Rng rng(1, "values");
  for (EpisodeResult& result : results) result.goals[0].spl = rng.Uniform();
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
    result.goals.back().success = true;
    result.goals.back().spl = 1.0;
  }
  const auto rows = Summarize(results, {});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_DOUBLE_EQ(Find(rows, "nts", "goals_1").success, 0.5);
  EXPECT_DOUBLE_EQ(Find(rows, "nts", "goals_2").success, 0.75);
  EXPECT_DOUBLE_EQ(Find(rows, "nts", "goals_2").spl, 0.625);
  EXPECT_DOUBLE_EQ(Find(rows, "nts", "goals_2").steps_mean, 30.0);
  EXPECT_DOUBLE_EQ(Find(rows, "nts", "overall").success, 0.75);
  EXPECT_EQ(Find(rows, "nts", "overall").paper_success, std::nullopt);  // of single goals
}

TEST(Summarize, AllGoalsOfASequenceAreExactlyOne) {
  EpisodeResult result = Result("nts", Difficulty::kEasy, 0, true, 1.0);
  result.goals.resize(10, result.goals[0]);
  const auto rows = Summarize({result, result}, {});
  for (const SummaryRow& row : rows) {
    EXPECT_EQ(row.success, 1.0) << row.difficulty;
    EXPECT_EQ(row.success_ci.high, 1.0) << row.difficulty;
    EXPECT_LE(row.success_ci.low, 1.0) << row.difficulty;
    EXPECT_EQ(row.spl_ci, (Interval{1.0, 1.0})) << row.difficulty;
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
  EXPECT_EQ(FindPublished("nts", "rgb", "noise", "overall").success, 0.55);
  EXPECT_EQ(FindPublished("nts", "rgb", "noise", "overall").spl, 0.38);
  EXPECT_EQ(FindPublished("metric_map_fbe", "rgbd", "no_noise", "hard").success, 0.23);
  EXPECT_EQ(FindPublished("metric_map_fbe", "rgbd", "no_noise", "hard").spl, std::nullopt);
  EXPECT_EQ(FindPublished("metric_map_fbe", "rgb", "noise", "easy").success, std::nullopt);
  EXPECT_EQ(FindPublished("nts", "rgb", "no_stop", "easy").success, std::nullopt);
  EXPECT_EQ(FindPublished("random", "rgbd", "noise", "easy").success, std::nullopt);
  EXPECT_EQ(FindPublished("nts", "rgbd", "noise", "goals_1").success, std::nullopt);
}

/// The paper's overall column is the mean of the three before it, to its two digits.
TEST(Published, OverallIsTheMeanOfTheDifficulties) {
  for (const char* agent : {"resnet_gru_il", "target_driven_rl", "metric_map_rl", "metric_map_fbe",
                            "active_neural_slam", "nts"}) {
    for (const char* setting : {"rgb", "rgbd"}) {
      for (const char* condition : {"noise", "no_stop", "no_noise"}) {
        const auto figure = [&](const char* difficulty) {
          return FindPublished(agent, setting, condition, difficulty);
        };
        if (!figure("easy").success) continue;
        const double mean =
            (*figure("easy").success + *figure("medium").success + *figure("hard").success) / 3;
        EXPECT_NEAR(*figure("overall").success, mean, 0.0101) << agent << setting << condition;
        if (!figure("easy").spl) continue;
        const double spl = (*figure("easy").spl + *figure("medium").spl + *figure("hard").spl) / 3;
        EXPECT_NEAR(*figure("overall").spl, spl, 0.0101) << agent << setting << condition;
      }
    }
  }
}

}  // namespace
}  // namespace bulletnav::bench
