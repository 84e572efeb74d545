// SPDX-License-Identifier: MIT
#include "benchmark/report/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <fmt/core.h>

#include "benchmark/report/palette.h"
#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kPanelWidth = 300.0;
constexpr double kPanelHeight = 210.0;
constexpr double kLeft = 52.0;  // for the labels of the axes
constexpr double kRight = 14.0;
constexpr double kTop = 14.0;
constexpr double kBottom = 44.0;
constexpr double kLegendLine = 17.0;
constexpr double kTick = 10.5;   // size of text
constexpr double kLabel = 12.0;  // size of text
constexpr Paint kGrid = {0.88, 0.88, 0.88};

constexpr Paint kReference = {0.45, 0.45, 0.45};

/// How the line of a series is drawn; `number` is its place in the chart.
Stroke StrokeOf(const Chart::Series& series, std::size_t number) {
  if (series.is_reference) return {1.2, kReference, {2.0, 3.0}};
  static const std::array<std::vector<double>, 4> dashes = {
      {{}, {7.0, 3.0}, {1.8, 2.6}, {7.0, 2.2, 1.8, 2.2}}};
  const std::size_t round = number / kLineColors.size();
  return {1.8, kLineColors[number % kLineColors.size()], dashes[round % dashes.size()]};
}

/// Shapes tell lines apart in print without colour.
void DrawMarker(const Point& at, std::size_t series, Canvas* canvas) {
  const Paint& paint = kLineColors[series % kLineColors.size()];
  constexpr std::array<int, 4> kCorners = {0, 4, 3, 5};  // 0: a disc
  const int corners =
      kCorners[(series % kLineColors.size() + series / kLineColors.size()) % kCorners.size()];
  if (corners == 0) {
    canvas->Disc(at, 3.4, paint);
    return;
  }
  std::vector<Point> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * sim::kPi * (i + (corners == 4 ? 0.5 : 0.0)) / corners;
    polygon.push_back(at + 4.2 * Point(sim::Sin(angle), -sim::Cos(angle)));
  }
  canvas->Fill(polygon, paint);
}

bool MarksAll(const Chart& chart, const Chart::Series& series) {
  return chart.has_marks && !series.is_reference;
}

/// One chart: where its values lie, and its parts.
class Panel {
 public:
  Panel(const Chart& chart, const Point& corner, Canvas* canvas)
      : chart_(chart), corner_(corner), canvas_(canvas) {
    low_ = std::numeric_limits<double>::infinity();
    high_ = -low_;
    for (const Chart::Series& series : chart.series) {
      for (const Chart::Value& value : series.values) {
        low_ = std::min(low_, value.x);
        high_ = std::max(high_, value.x);
      }
    }
    for (const Chart::Tick& tick : chart.ticks) {
      low_ = std::min(low_, tick.x);
      high_ = std::max(high_, tick.x);
    }
    if (!(low_ <= high_)) low_ = high_ = 0.0;
    low_ -= chart.margin;
    high_ += chart.margin;
  }

  void Axes() const {
    for (int i = 0; i <= 5; ++i) {
      const double y = chart_.top * i / 5.0;
      canvas_->Line(At(low_, y), At(high_, y), 0.8, kGrid);
      const std::string label =
          chart_.top > 1.0 ? fmt::format("{:g}", y) : fmt::format("{:.1f}", y);
      canvas_->Text(At(low_, y) - Point(6.0, 0.0), label,
                    {.size = kTick, .paint = kInk, .align = Align::kRight});
    }
    for (const Chart::Tick& tick : Ticks()) {
      const Point at = At(tick.x, 0.0);
      canvas_->Line(at, at + Point(0.0, 4.0), 1.0, kInk);
      canvas_->Text(at + Point(0.0, 13.0), tick.text, {.size = kTick, .paint = kInk});
    }
    canvas_->Line(At(low_, 0.0), At(high_, 0.0), 1.0, kInk);
    canvas_->Line(At(low_, 0.0), At(low_, chart_.top), 1.0, kInk);
    canvas_->Text(At(0.5 * (low_ + high_), 0.0) + Point(0.0, 32.0), chart_.x_label,
                  {.size = kLabel, .paint = kInk});
    canvas_->Text(At(low_, 0.5 * chart_.top) - Point(38.0, 0.0), chart_.y_label,
                  {.size = kLabel, .paint = kInk, .upwards = true});
  }

  void Band(std::size_t i) const {
    const auto& values = chart_.series[i].values;
    std::vector<Point> band;
    band.reserve(2 * values.size());
    for (const Chart::Value& v : values) band.push_back(At(v.x, v.interval.high));
    for (auto v = values.rbegin(); v != values.rend(); ++v) {
      band.push_back(At(v->x, v->interval.low));
    }
    const Paint paint = StrokeOf(chart_.series[i], i).paint;
    canvas_->Fill(band, paint.WithAlpha(0.15));
    // A band of one value has no area: its interval as a bar.
    if (values.size() == 1) canvas_->Line(band[0], band[1], 1.2, paint.WithAlpha(0.6));
  }

  void Line(std::size_t i) const {
    const Chart::Series& series = chart_.series[i];
    std::vector<Point> points;
    for (const Chart::Value& v : series.values) points.push_back(At(v.x, v.y));
    canvas_->Polyline(points, StrokeOf(series, i));
    const bool marks_all = MarksAll(chart_, series);
    for (const Chart::Value& v : series.values) {
      if (marks_all || v.x == series.chosen) DrawMarker(At(v.x, v.y), i, canvas_);
    }
  }

 private:
  std::vector<Chart::Tick> Ticks() const {
    if (!chart_.ticks.empty()) return chart_.ticks;
    std::vector<Chart::Tick> ticks;
    const int step = TickStep(high_ - low_);
    const int first = static_cast<int>(std::ceil(low_));
    for (int x = step < 5 ? first : (first + step - 1) / step * step; x <= high_; x += step) {
      ticks.push_back({static_cast<double>(x), std::to_string(x)});
    }
    return ticks;
  }

  Point At(double x, double y) const {
    return corner_ + Point(kLeft + kPanelWidth * (x - low_) / (high_ - low_),
                           kTop + kPanelHeight * (1.0 - y / chart_.top));
  }

  const Chart& chart_;
  Point corner_;
  Canvas* canvas_;
  double low_ = 0.0;
  double high_ = 0.0;
};

void DrawLegend(const Chart& chart, double top, Canvas* canvas) {
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Point at(kLeft, top + kLegendLine * (static_cast<double>(i) + 0.5));
    const Chart::Series& series = chart.series[i];
    const std::vector<Point> line = {at, at + Point(24.0, 0.0)};
    canvas->Polyline(line, StrokeOf(series, i));
    if (MarksAll(chart, series) || series.chosen) DrawMarker(at + Point(12.0, 0.0), i, canvas);
    canvas->Text(at + Point(32.0, 0.0), series.name,
                 {.size = kTick, .paint = kInk, .align = Align::kLeft});
  }
}

}  // namespace

int TickStep(double width) {
  if (width <= 24.0) return width > 12.0 ? 2 : 1;
  for (int unit = 5;; unit *= 10) {
    for (const int times : {1, 2, 4}) {
      if (width / (times * unit) <= 12.0) return times * unit;
    }
  }
}

double RoundTop(double value) {
  if (value <= 1.0) return 1.0;
  double unit = 1.0;
  while (unit < value) unit *= 10.0;
  double top = unit;
  for (const double share : {0.5, 0.25, 0.2}) {
    if (share * unit >= value) top = share * unit;
  }
  return top;
}

Figure ChartFigure(std::span<const Chart> charts) {
  const auto shared = std::make_shared<const std::vector<Chart>>(charts.begin(), charts.end());
  const std::size_t series = charts.empty() ? 0 : charts.front().series.size();
  for (const Chart& chart : charts) BULLETNAV_CHECK_EQ(chart.series.size(), series);
  const double pitch = kLeft + kPanelWidth + kRight;
  const double legend = kTop + kPanelHeight + kBottom;
  Figure figure;
  figure.width =
      static_cast<int>(pitch * static_cast<double>(std::max<std::size_t>(1, charts.size())));
  figure.height = static_cast<int>(legend + kLegendLine * static_cast<double>(series) + 6.0);
  figure.draw = [shared, series, pitch, legend](Canvas* canvas) {
    if (series == 0) {
      canvas->Text({0.5 * pitch, 0.5 * legend}, "no results", {.size = kLabel, .paint = kInk});
      return;
    }
    for (std::size_t k = 0; k < shared->size(); ++k) {
      const Panel panel((*shared)[k], {pitch * static_cast<double>(k), 0.0}, canvas);
      panel.Axes();
      for (std::size_t i = 0; i < series; ++i) panel.Band(i);
      for (std::size_t i = 0; i < series; ++i) panel.Line(i);
    }
    DrawLegend(shared->front(), legend, canvas);
  };
  return figure;
}

}  // namespace bulletnav::bench
