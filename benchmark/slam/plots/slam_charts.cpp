// SPDX-License-Identifier: MIT
#include "benchmark/slam/plots/slam_charts.h"

#include <cstddef>
#include <string>
#include <vector>

#include "benchmark/report/chart.h"
#include "benchmark/slam/runs/rankings.h"

namespace bulletnav::bench {
namespace {

using Results = std::vector<const DriveResult*>;

Results PointersTo(std::span<const DriveResult> results) {
  Results pointers;
  pointers.reserve(results.size());
  for (const DriveResult& result : results) pointers.push_back(&result);
  return pointers;
}

double GuessingOf(const RankingOutcome& ranking) {
  return ranking.figures.guessing;
}

Chart::Value Point(double x, double y) {
  return {x, y, {y, y}};
}

/// Mean precision at each recall.
Chart::Series CurveOf(const std::string& name, const Rankings& rankings) {
  Chart::Series series{name, {}};
  if (rankings.empty()) return series;
  const std::size_t points = rankings.front()->precision.size();
  for (std::size_t i = 0; i < points; ++i) {
    const double precision = MeanOf(rankings, [i](const RankingOutcome& ranking) {
      return i < ranking.precision.size() ? ranking.precision[i] : 0.0;
    });
    // No point where nothing is found: the line ends there.
    if (precision == 0.0) break;
    series.values.push_back(
        Point(static_cast<double>(i) / static_cast<double>(points - 1), precision));
  }
  return series;
}

Chart KindChart(const SlamConfig& config, const Results& results, LoopKind kind) {
  Chart chart;
  chart.x_label = "Recall, loops are: " + std::string(NameOf(kind));
  chart.y_label = "Precision";
  chart.has_marks = false;
  chart.margin = 0.02;
  for (const double tick : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    chart.ticks.push_back({tick, std::to_string(tick).substr(0, 4)});
  }
  for (std::size_t i = 0; i < config.detectors.size(); ++i) {
    chart.series.push_back(CurveOf(config.detectors[i].name, RankingsOf(results, i, kind)));
  }
  const double guessing = MeanOf(RankingsOf(results, 0, kind), GuessingOf);
  chart.series.push_back({"guessing", {Point(0.0, guessing), Point(1.0, guessing)}, true});
  return chart;
}

}  // namespace

Figure PrecisionRecallFigure(const SlamConfig& config, std::span<const DriveResult> results) {
  const Results pointers = PointersTo(results);
  std::vector<Chart> charts;
  for (const LoopKind kind : {LoopKind::kCovisible, LoopKind::kNode, LoopKind::kNear}) {
    // Recordings have no walkable floor, so that nobody knows what is one node.
    if (!RankingsOf(pointers, 0, kind).empty()) charts.push_back(KindChart(config, pointers, kind));
  }
  if (charts.empty()) charts.push_back(KindChart(config, pointers, LoopKind::kCovisible));
  return ChartFigure(charts);
}

namespace {

/// Mean over drives in each bin of headings.
template <class Value>
Chart::Series HeadingSeries(const std::string& name, const Results& results, std::size_t detector,
                            const Value& value) {
  Chart::Series series{name, {}};
  for (int bin = 0; bin < kHeadingBins; ++bin) {
    const Rankings rankings = RankingsOf(results, detector, static_cast<HeadingBin>(bin));
    series.values.push_back(Point(bin, MeanOf(rankings, value)));
  }
  return series;
}

}  // namespace

Figure HeadingFigure(const SlamConfig& config, std::span<const DriveResult> results) {
  const Results pointers = PointersTo(results);
  Chart chart;
  chart.x_label = "Later camera turned by, degrees";
  chart.y_label = "Average precision";
  for (int bin = 0; bin < kHeadingBins; ++bin) {
    chart.ticks.push_back(
        {static_cast<double>(bin), std::string(NameOf(static_cast<HeadingBin>(bin)))});
  }
  for (std::size_t i = 0; i < config.detectors.size(); ++i) {
    chart.series.push_back(
        HeadingSeries(config.detectors[i].name, pointers, i, [](const RankingOutcome& ranking) {
          return ranking.figures.average_precision;
        }));
  }
  chart.series.push_back(HeadingSeries("guessing", pointers, 0, GuessingOf));
  chart.series.back().is_reference = true;
  return ChartFigure({&chart, 1});
}

}  // namespace bulletnav::bench
