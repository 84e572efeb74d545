// SPDX-License-Identifier: MIT
#include "benchmark/slam/plots/scale_chart.h"

#include <cmath>
#include <string>

#include "benchmark/report/chart.h"

namespace bulletnav::bench {
namespace {

Chart::Series SeriesOf(const std::string& name, const ScaleResult& result,
                       double ScaleFigures::*recall) {
  Chart::Series series{name, {}};
  for (const ScaleFigures& row : result.figures) {
    const double y = row.*recall;
    series.values.push_back({std::log10(1.0 * row.frames), y, {y, y}});
  }
  return series;
}

}  // namespace

Figure ScaleFigure(const ScaleResult& result) {
  Chart chart;
  chart.x_label = "Frames";
  chart.y_label = "Queries whose loop is found";
  chart.margin = 0.1;
  for (const ScaleFigures& row : result.figures) {
    chart.ticks.push_back({std::log10(1.0 * row.frames), std::to_string(row.frames)});
  }
  chart.series = {SeriesOf("the first", result, &ScaleFigures::recall_1),
                  SeriesOf("among five", result, &ScaleFigures::recall_5),
                  SeriesOf("among ten", result, &ScaleFigures::recall_10)};
  return ChartFigure({&chart, 1});
}

}  // namespace bulletnav::bench
