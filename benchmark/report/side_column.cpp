// SPDX-License-Identifier: MIT
#include "benchmark/report/side_column.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "benchmark/report/palette.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kMargin = 10.0;
constexpr double kLine = 15.0;  // from line to line of text
constexpr double kText = 11.0;
constexpr double kBarHeight = 100.0;
constexpr int kBarSteps = 50;

constexpr double kLeastShrink = 0.8;  // what would be smaller still is broken into lines

}  // namespace

void SideColumn::Title(const std::string& text) {
  for (const std::string& line : Lines(text, 13.0, true)) {
    canvas_->Text(at_ + Point(0.0, 7.0), line,
                  {.size = FittingSize(line, 13.0, true),
                   .paint = kInk,
                   .bold = true,
                   .align = Align::kLeft});
    at_.y() += kLine;
  }
  at_.y() += 3.0;
}

void SideColumn::Line(const std::string& text) {
  for (const std::string& line : Lines(text, kText, false)) TextAt(at_.x(), line);
}

void SideColumn::TimeBar(int steps) {
  const double height = kBarHeight / kBarSteps;
  at_.y() += 5.0;
  for (int i = 0; i < kBarSteps; ++i) {
    // Each a little into the next: no seam shows between them.
    const double low = at_.y() + i * height;
    const double high = std::min(low + height + 0.5, at_.y() + kBarHeight);
    const std::vector<Point> box = {
        {at_.x(), low}, {at_.x() + 12.0, low}, {at_.x() + 12.0, high}, {at_.x(), high}};
    canvas_->Fill(box, TimeColor((i + 0.5) / kBarSteps));
  }
  for (int i = 0; i <= 4; ++i) {
    const double y = at_.y() + kBarHeight * i / 4.0;
    canvas_->Line({at_.x() + 12.0, y}, {at_.x() + 15.0, y}, 1.0, kInk);
    canvas_->Text({at_.x() + 19.0, y}, std::to_string((steps * i + 2) / 4),
                  {.size = kText, .paint = kInk, .align = Align::kLeft});
  }
  canvas_->Text({at_.x() + 52.0, at_.y() + 0.5 * kBarHeight}, "step",
                {.size = kText, .paint = kInk, .upwards = true});
  at_.y() += kBarHeight + 12.0;
}

void SideColumn::Entry(const LegendEntry& entry) {
  entry.draw(at_ + Point(0.5 * kSignWidth, 0.5 * kLine), canvas_);
  at_.y() += 2.0;
  TextAt(at_.x() + kSignWidth + 8.0, entry.text);
  at_.y() += 2.0;
}

std::vector<std::string> SideColumn::Lines(const std::string& text, double size, bool bold) const {
  std::vector<std::string> lines = {""};
  if (FittingSize(text, size, bold) >= kLeastShrink * size) {
    lines.front() = text;
    std::replace(lines.front().begin(), lines.front().end(), '\n', ' ');
    return lines;
  }
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || FittingSize(longer, size, bold) == size) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

double SideColumn::FittingSize(const std::string& text, double size, bool bold) const {
  const double width = canvas_->TextSize(text, size, bold).x();
  return size * std::min(1.0, (kSideColumnWidth - kMargin) / std::max(1.0, width));
}

void SideColumn::TextAt(double x, const std::string& text) {
  canvas_->Text({x, at_.y() + 0.4 * kLine}, text,
                {.size = FittingSize(text, kText, false), .paint = kInk, .align = Align::kLeft});
  at_.y() += kLine;
}

}  // namespace bulletnav::bench
