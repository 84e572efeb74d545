// SPDX-License-Identifier: MIT
// A measure added the way docs/extending.md says: one file, nothing else touched. Up to the line of
// slashes this is what would stand in benchmark/play/measures/clear_steps.cpp.
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Share of the steps to a goal reached in which the body met nothing.
double ClearSteps(const GoalRecord& record, const SuccessRule& /*rule*/) {
  return record.steps > 0 ? 1.0 - static_cast<double>(record.collisions) / record.steps : 1.0;
}

const MeasureRegistration registration({
    .name = "clear_steps",
    .value = ClearSteps,
    .over_goals = OverGoals::kMeanOfReached,
    .column = "clear_steps_mean",
    .label = "clear steps",
    .table_title = "Clear",
});

}  // namespace
}  // namespace bulletnav::bench

////////////////////////////////////////////////////////////////////////////////////////////////////

#include <gmock/gmock.h>

#include "benchmark/play/episode_result.h"
#include "benchmark/report/result_charts.h"
#include "benchmark/report/run_tables.h"
#include "benchmark/runs/comparison.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

/// 8 steps, one of them a collision in every other episode; the last does not stop at the goal.
std::vector<EpisodeResult> Results() {
  std::vector<EpisodeResult> results;
  for (int i = 0; i < 6; ++i) {
    const GoalRecord record = {4.5, 0.5, 0.5, 4.0, i != 5, 8, i % 2};
    results.push_back({{"nts", "rgbd", "noise", 0, "house.glb", std::to_string(i)},
                       Difficulty::kEasy,
                       {MeasureGoal(record, {})},
                       ""});
  }
  return results;
}

/// The same, as a program wrote it that did not have the measure.
std::vector<EpisodeResult> OlderResults() {
  std::vector<EpisodeResult> older = Results();
  for (EpisodeResult& result : older) {
    std::string line = ToJsonLine(result);
    line.erase(line.find(",\"clear_steps\""), line.rfind('}') - line.find(",\"clear_steps\""));
    result = FromJsonLine(line, "older.jsonl", 1);
  }
  return older;
}

TEST(OneFileMeasure, StandsInTheLineOfAnEpisode) {
  const std::string line = ToJsonLine(Results()[1]);
  EXPECT_THAT(line, testing::EndsWith(R"("steps":8,"collisions":1,"clear_steps":0.875})"));
  EXPECT_EQ(FromJsonLine(line, "x", 1), Results()[1]);
}

TEST(OneFileMeasure, HasColumnsInSummaries) {
  const auto rows = Summarize(Results(), {});
  EXPECT_DOUBLE_EQ(*rows[0].Of("clear_steps").mean, (3 * 1.0 + 2 * 0.875) / 5)
      << "of goals reached";
  EXPECT_THAT(SummaryToJson(rows), HasSubstr("\"clear_steps_mean\": 0.95,\n"));
  EXPECT_THAT(SummaryToJson(rows), HasSubstr("\"clear_steps_mean_ci\": ["));
  const std::string csv = SummaryToCsv(rows);
  EXPECT_THAT(csv, HasSubstr(",distance_to_goal_mean,clear_steps_mean,clear_steps_mean_ci_low,"
                             "clear_steps_mean_ci_high,note\n"));
  EXPECT_THAT(csv, HasSubstr(",0.5,0.95,"));
}

TEST(OneFileMeasure, IsEmptyInSummariesOfOlderRuns) {
  const auto rows = Summarize(OlderResults(), {});
  EXPECT_THAT(SummaryToJson(rows), HasSubstr("\"clear_steps_mean\": null"));
  EXPECT_THAT(SummaryToCsv(rows), HasSubstr(",0.5,,,,\n"));
  EXPECT_EQ(MakeTables(rows, {})[0].rows[0].cells[2], "");
}

TEST(OneFileMeasure, HasColumnsInTables) {
  const auto tables = MakeTables(Summarize(Results(), {}), {});
  EXPECT_THAT(tables[0].groups[0].columns, testing::ElementsAre("Succ", "SPL", "Clear"));
  EXPECT_EQ(tables[0].rows[0].cells[2], "0.95");
}

TEST(OneFileMeasure, IsComparedAndDrawn) {
  const Comparison comparison = CompareRuns(Results(), Results(), {});
  EXPECT_THAT(ToText(comparison), HasSubstr("clear steps 0.95 -> 0.95"));
  EXPECT_THAT(ToText(comparison), HasSubstr("    5 pairs  clear steps"));
  EXPECT_EQ(CompareRuns(Results(), OlderResults(), {}).rows[0].measures.size(), 2u);
  const auto charts = DistanceCharts(Results(), {});
  ASSERT_EQ(charts.size(), 3u);
  EXPECT_EQ(charts[2].y_label, "clear steps");
}

TEST(OneFileMeasure, ASecondOfTheSameNameIsRefused) {
  try {
    const MeasureRegistration again({.name = "clear_steps", .value = ClearSteps});
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("'clear_steps'"));
  }
}

}  // namespace
}  // namespace bulletnav::bench
