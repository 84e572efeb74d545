// SPDX-License-Identifier: MIT
#include "benchmark/slam/plots/heading_histogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "benchmark/report/palette.h"

namespace bulletnav::bench {
namespace {

constexpr double kWidth = 260.0;
constexpr double kHeight = 180.0;
constexpr double kTitle = 40.0;
constexpr double kAxis = 44.0;
constexpr double kLeft = 52.0;
constexpr double kGap = 16.0;
constexpr std::size_t kInARow = 4;  // panels
constexpr double kBinDegrees = 180.0 / HeadingCounts::kBins;

int Sum(const std::vector<int>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0);
}

int HighestOf(const std::vector<HeadingCounts>& detectors) {
  int highest = 1;
  for (const HeadingCounts& counts : detectors) {
    for (std::size_t i = 0; i < counts.right.size(); ++i) {
      highest = std::max(highest, counts.right[i] + counts.wrong[i]);
    }
  }
  return highest;
}

void FillBox(const Canvas::Point& low, const Canvas::Point& high, const Paint& paint,
             Canvas* canvas) {
  const std::array<Canvas::Point, 4> corners = {low, Canvas::Point(high.x(), low.y()), high,
                                                Canvas::Point(low.x(), high.y())};
  canvas->Fill(corners, paint);
}

/// `corner` is where the axes meet.
void DrawBars(const HeadingCounts& counts, const Canvas::Point& corner, double unit,
              Canvas* canvas) {
  constexpr double kBar = kWidth / HeadingCounts::kBins;
  const double bottom = corner.y();
  for (std::size_t i = 0; i < counts.right.size(); ++i) {
    const double x = corner.x() + kBar * static_cast<double>(i);
    const double right_top = bottom - unit * counts.right[i];
    const double wrong_top = right_top - unit * counts.wrong[i];
    FillBox({x + 1.0, right_top}, {x + kBar - 1.0, bottom}, kBlue, canvas);
    FillBox({x + 1.0, wrong_top}, {x + kBar - 1.0, right_top}, kVermillion, canvas);
  }
}

/// `left`, `top`: of the panel, without the labels of the left axis.
void DrawPanel(const HeadingCounts& counts, double left, double top, int highest, Canvas* canvas) {
  const double high = top + kTitle;
  const double bottom = high + kHeight;
  canvas->Line({left, bottom}, {left + kWidth, bottom}, 1.0, kInk);
  canvas->Line({left, high}, {left, bottom}, 1.0, kInk);
  DrawBars(counts, {left, bottom}, kHeight / highest, canvas);
  const std::string title = counts.name + ": " + std::to_string(Sum(counts.right)) + " right, " +
                            std::to_string(Sum(counts.wrong)) + " wrong";
  canvas->Text({left + kWidth / 2.0, top + kTitle / 2.0}, title,
               {13.0, kInk, true, Align::kCenter, false, false});
  for (int degrees = 0; degrees <= 180; degrees += 45) {
    canvas->Text({left + kWidth * degrees / 180.0, bottom + 12.0}, std::to_string(degrees),
                 {12.0, kInk, false, Align::kCenter, false, false});
  }
  canvas->Text({left + kWidth / 2.0, bottom + 32.0}, "later camera turned by, degrees",
               {12.0, kInk, false, Align::kCenter, false, false});
  canvas->Text({left - 6.0, high}, std::to_string(highest),
               {12.0, kInk, false, Align::kRight, false, false});
  canvas->Text({left - 24.0, bottom - kHeight / 2.0}, "accepted loops",
               {12.0, kInk, false, Align::kCenter, false, true});
  canvas->Text({left - 6.0, bottom}, "0", {12.0, kInk, false, Align::kRight, false, false});
}

}  // namespace

void HeadingCounts::Add(double turned_deg, bool is_wrong) {
  const double turned = std::abs(turned_deg);
  const auto bin =
      static_cast<std::size_t>(std::clamp(static_cast<int>(turned / kBinDegrees), 0, kBins - 1));
  ++(is_wrong ? wrong : right)[bin];
}

Figure HeadingHistogram(const std::vector<HeadingCounts>& detectors) {
  Figure figure;
  constexpr double kColumn = kLeft + kWidth + kGap;
  constexpr double kRow = kTitle + kHeight + kAxis;
  const std::size_t columns = std::min(kInARow, detectors.size());
  const std::size_t rows = (detectors.size() + kInARow - 1) / kInARow;
  figure.width = static_cast<int>(kGap + static_cast<double>(columns) * kColumn);
  figure.height = static_cast<int>(kRow * static_cast<double>(rows));
  figure.draw = [detectors](Canvas* canvas) {
    const int highest = HighestOf(detectors);
    for (std::size_t i = 0; i < detectors.size(); ++i) {
      const std::size_t column = i % kInARow;
      const std::size_t row = i / kInARow;
      DrawPanel(detectors[i], kLeft + kColumn * static_cast<double>(column),
                kRow * static_cast<double>(row), highest, canvas);
    }
  };
  return figure;
}

}  // namespace bulletnav::bench
