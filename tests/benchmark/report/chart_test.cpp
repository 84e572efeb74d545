// SPDX-License-Identifier: MIT
#include "benchmark/report/chart.h"

#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "benchmark/report/palette.h"
#include "benchmark/report/result_charts.h"
#include "tests/support/svg.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

EpisodeResult Result(const std::string& agent, double distance, bool success, int goals = 1) {
  EpisodeResult result;
  result.key = {agent, "rgbd", "noise", 0, "house.glb", "0"};
  GoalMetrics metrics;
  metrics["start_distance"] = distance;
  metrics["success"] = success;
  metrics["spl"] = success ? 0.5 : 0.0;
  result.goals.assign(static_cast<std::size_t>(goals), metrics);
  return result;
}

/// Ten episodes of 2 to 3 m, of which seven succeed, four of 5 m.
std::vector<EpisodeResult> Results() {
  std::vector<EpisodeResult> results;
  for (int i = 0; i < 10; ++i) results.push_back(Result("random", 2.0 + 0.09 * i, i < 7));
  for (int i = 0; i < 4; ++i) results.push_back(Result("random", 5.0, true));
  return results;
}

std::vector<Chart> TwoCharts() {
  Chart chart{"number of goals", "success", {}};
  chart.series.push_back({"a", {{1, 0.9, {0.8, 1.0}}, {2, 0.5, {0.4, 0.6}}}});
  chart.series.push_back({"b", {{1, 0.25, {0.0, 0.4}}}});
  return {chart, chart};
}

/// Whether a colour, or one within rounding of it, is somewhere in a picture.
bool Shows(const sim::Image& image, const Paint& paint) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      if (std::abs(p[0] - 255.0 * paint.red) < 2.0 && std::abs(p[1] - 255.0 * paint.green) < 2.0 &&
          std::abs(p[2] - 255.0 * paint.blue) < 2.0) {
        return true;
      }
    }
  }
  return false;
}

TEST(Chart, SeriesHaveColoursOfTheirOwn) {
  const sim::Image image = ToImage(ChartFigure(TwoCharts()));
  EXPECT_TRUE(Shows(image, kLineColors[0]));
  EXPECT_TRUE(Shows(image, kLineColors[1]));
  EXPECT_FALSE(Shows(image, kLineColors[2]));
}

/// 28 lines; a grid's and axes' strokes are not dashed.
TEST(Chart, ManySeriesCanBeToldApart) {
  Chart chart{"recall", "precision", {}};
  for (int i = 0; i < 28; ++i) {
    chart.series.push_back({std::to_string(i), {{0, 0.5, {0.5, 0.5}}, {1, 0.5, {0.5, 0.5}}}});
  }
  const std::string svg = ToSvg(ChartFigure(std::vector{chart}));
  const std::regex line("stroke:(rgb[^;]*);[^\"]*stroke-dasharray:([^;]*);");
  std::set<std::pair<std::string, std::string>> strokes;
  for (std::sregex_iterator at(svg.begin(), svg.end(), line), end; at != end; ++at) {
    strokes.emplace((*at)[1], (*at)[2]);
  }
  EXPECT_EQ(strokes.size(), 28U - kLineColors.size());
}

TEST(Chart, ValuesLieWhereTheAxesSay) {
  // The first value of the first series at 0.9: a disc in the first panel.
  const sim::Image image = ToImage(ChartFigure(TwoCharts()), 1.0);
  const std::uint8_t* p = image.at(52 + 300 / 4, 14 + 21);
  EXPECT_NEAR(p[0], 255.0 * kLineColors[0].red, 2.0);
  EXPECT_NEAR(p[2], 255.0 * kLineColors[0].blue, 2.0);
  // The band of it reaches down to 0.8 and no farther.
  EXPECT_LT(image.at(52 + 300 / 4 + 3, 14 + 35)[0], 230);
  EXPECT_EQ(image.at(52 + 300 / 4 + 3, 14 + 65)[0], 255);
}

TEST(Chart, LargerNumbersLieUnderARoundTop) {
  Chart chart{"steps", "m2", {}};
  chart.series.push_back({"a", {{1, 60.0, {60.0, 60.0}}, {2, 90.0, {90.0, 90.0}}}});
  chart.top = RoundTop(90.0);
  EXPECT_EQ(chart.top, 100.0);
  const sim::Image image = ToImage(ChartFigure({&chart, 1}), 1.0);
  const std::uint8_t* p = image.at(52 + 300 / 4, 14 + 84);  // 60 of 100
  EXPECT_NEAR(p[0], 255.0 * kLineColors[0].red, 2.0);
  EXPECT_NEAR(p[2], 255.0 * kLineColors[0].blue, 2.0);
}

TEST(Chart, ARoundTopIsTheNextOne) {
  EXPECT_EQ(RoundTop(0.3), 1.0);
  EXPECT_EQ(RoundTop(1.0), 1.0);
  EXPECT_EQ(RoundTop(1.1), 2.0);
  EXPECT_EQ(RoundTop(2.2), 2.5);
  EXPECT_EQ(RoundTop(110.4), 200.0);
  EXPECT_EQ(RoundTop(510.0), 1000.0);
}

TEST(Chart, SvgIsSoundAndTheSameEachTime) {
  const std::string svg = ToSvg(ChartFigure(TwoCharts()));
  EXPECT_EQ(tests::SvgProblem(svg), "");
  EXPECT_EQ(ToSvg(ChartFigure(TwoCharts())), svg);
}

TEST(Chart, NamesOfManyNumbersHaveRoom) {
  EXPECT_EQ(TickStep(4.0), 1);
  EXPECT_EQ(TickStep(13.0), 2);
  EXPECT_EQ(TickStep(24.0), 2);
  EXPECT_EQ(TickStep(50.0), 5);
  EXPECT_EQ(TickStep(100.0), 10);
  EXPECT_EQ(TickStep(200.0), 20);
  EXPECT_EQ(TickStep(600.0), 50);
  EXPECT_EQ(TickStep(1000.0), 100);
  for (double width = 1.0; width < 1e6; width *= 1.1) EXPECT_LE(width / TickStep(width), 12.0);
}

TEST(Chart, NothingToShowIsSaidNotDrawn) {
  EXPECT_EQ(tests::SvgProblem(ToSvg(ChartFigure({}))), "");
  EXPECT_TRUE(DistanceCharts({}, {}).empty());
  EXPECT_TRUE(GoalCountCharts({}, {}).empty());
}

TEST(ResultCharts, DistanceIsBinnedByTheMetreAndSmallBinsLeftOut) {
  const auto charts = DistanceCharts(Results(), {});
  ASSERT_EQ(charts.size(), 2u);
  ASSERT_EQ(charts[0].series.size(), 1u);
  const auto& values = charts[0].series[0].values;
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(values[0].x, 2.5);
  EXPECT_DOUBLE_EQ(values[0].y, 0.7);
  EXPECT_EQ(values[0].interval, WilsonInterval(7, 10));
  EXPECT_DOUBLE_EQ(charts[1].series[0].values[0].y, 0.35);
}

TEST(ResultCharts, OrderOfResultsDoesNotMatter) {
  std::vector<EpisodeResult> results = Results();
  const auto charts = DistanceCharts(results, {});
  std::reverse(results.begin(), results.end());
  EXPECT_EQ(ToSvg(ChartFigure(DistanceCharts(results, {}))), ToSvg(ChartFigure(charts)));
}

TEST(ResultCharts, SequencesAreDrawnByNumberOfGoals) {
  std::vector<EpisodeResult> results;
  for (int i = 0; i < 6; ++i) results.push_back(Result("nts", 3.0, i % 2 == 0, 3));
  const std::vector<AgentRow> agents = {{"nts", "", {}, "oracle"}};
  const auto charts = GoalCountCharts(Summarize(results, agents), agents);
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_THAT(charts[0].series[0].name, HasSubstr("(rgbd, noise, oracle)"));
  const auto& values = charts[0].series[0].values;
  ASSERT_EQ(values.size(), 3u);
  EXPECT_EQ(values[2].x, 3.0);
  EXPECT_DOUBLE_EQ(values[2].y, 0.5);
  EXPECT_TRUE(DistanceCharts(results, {}).empty());
}

}  // namespace
}  // namespace bulletnav::bench
