// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/base/statistics.h"
#include "benchmark/report/figure.h"

namespace bulletnav::bench {

/// Shares, all in [0, 1], against something countable, with their confidence, or a curve of one
/// share against another; or other numbers from 0 on, with a higher `top`.
struct Chart {
  struct Value {
    double x = 0.0;
    double y = 0.0;
    Interval interval;
  };
  struct Series {
    std::string name;
    std::vector<Value> values;          // by rising x
    bool is_reference = false;          // what others are looked at beside: grey, without marks
    std::optional<double> chosen = {};  // the x of a value that has a mark in any case
  };
  struct Tick {
    double x = 0.0;
    std::string text;
  };
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;    // as many, in the same order, in all charts of a figure
  std::vector<Tick> ticks = {};  // of x, which reaches so far at least; whole numbers if empty
  double margin = 0.5;           // of x beyond values and ticks
  double top = 1.0;              // of y
  bool has_marks = true;         // on each value
};

/// How far apart whole numbers are whose names have room along an axis of so many: 1, 2, 5, 10, 20,
/// 50, ...
int TickStep(double width);

/// The least round number that is not below a value nor below 1 and whose fifth is round, too.
double RoundTop(double value);

/// Charts side by side under a common legend: a line with marks a series and a band for its
/// intervals. Where there are more series than colours, lines of the same colour have other dashes.
/// Expects: as many series in each (checked). With no chart or no series the figure says that there
/// are no results.
Figure ChartFigure(std::span<const Chart> charts);

}  // namespace bulletnav::bench
