// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_charts.h"

#include <cmath>
#include <string>

#include <fmt/core.h>

#include "benchmark/report/chart.h"

namespace bulletnav::bench {
namespace {

using Value = Chart::Value;

constexpr std::int64_t kFewest = 10;  // cases of a bin; shares of fewer mean nothing

/// One figure of all bins; those of too few cases are left out.
Chart::Series SeriesOf(const char* name, const std::vector<ConnectionBin>& bins,
                       MeanFigure ConnectionBin::*member) {
  Chart::Series series = {name, {}};
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const MeanFigure& mean = bins[i].*member;
    if (mean.count < kFewest) continue;
    const bool is_known = std::isfinite(mean.interval.low);
    const Interval none = {mean.value, mean.value};
    series.values.push_back({static_cast<double>(i), mean.value, is_known ? mean.interval : none});
  }
  return series;
}

Chart BinsChart(const char* label, const std::vector<ConnectionBin>& bins) {
  Chart chart;
  chart.x_label = label;
  chart.y_label = "share of pairs";
  chart.series = {
      SeriesOf("right answers", bins, &ConnectionBin::accuracy),
      SeriesOf("pairs of one node: found", bins, &ConnectionBin::recall),
      SeriesOf("pairs of two: taken for one", bins, &ConnectionBin::false_positive_rate)};
  for (std::size_t i = 0; i < bins.size(); ++i) {
    chart.ticks.push_back({static_cast<double>(i), bins[i].bin});
  }
  return chart;
}

}  // namespace

Figure PrecisionRecallFigure(const ConnectionFigures& figures) {
  Chart chart;
  chart.x_label = "recall";
  chart.y_label = "precision";
  chart.margin = 0.0;
  chart.has_marks = false;
  Chart::Series model = {fmt::format("model, average precision {:.2f}", figures.average_precision),
                         {}};
  for (const PrecisionRecall& point : figures.curve) {
    model.values.push_back({point.recall, point.precision, {point.precision, point.precision}});
  }
  const double share = figures.prevalence;
  const Chart::Series guess = {fmt::format("guessing, {:.2f}", share),
                               {{0.0, share, {share, share}}, {1.0, share, {share, share}}}};
  chart.series = {model, guess};
  for (int i = 0; i <= 5; ++i) chart.ticks.push_back({0.2 * i, fmt::format("{:.1f}", 0.2 * i)});
  return ChartFigure({&chart, 1});
}

Figure ConnectionBinsFigure(const ConnectionFigures& figures) {
  const std::vector<Chart> charts = {BinsChart("metres between, straight", figures.by_distance),
                                     BinsChart("walls between", figures.by_walls),
                                     BinsChart("walls between, within 3 m", figures.by_walls_near)};
  return ChartFigure(charts);
}

}  // namespace bulletnav::bench
