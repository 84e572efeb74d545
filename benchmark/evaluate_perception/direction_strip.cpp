// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/direction_strip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "agent/perception/relative_pose.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr Paint kGrid = {0.86, 0.86, 0.86};
constexpr double kSmall = 10.0;  // text

}  // namespace

double DirectionStrip::At(int direction) const {
  const int place = (kCells / 2 - direction + kCells) % kCells;
  return left_ + cell() * (place + 0.5);
}

double DirectionStrip::AtBearing(double bearing) const {
  const double turns = (sim::kPi - sim::WrapAngle(bearing)) / (2.0 * sim::kPi) + 0.5 / kCells;
  return left_ + width_ * (turns - std::floor(turns));
}

void DirectionStrip::Panorama(const sim::Image& image, double top) const {
  const double across = width_ / image.width;
  const double down = panorama_height() / image.height;
  canvas_->Picture(image, Eigen::Translation2d(left_, top) * Eigen::AlignedScaling2d(across, down),
                   true);
}

void DirectionStrip::Bearings(double y) const {
  for (int i = 0; i < kCells; ++i) {
    const auto degrees = std::lround(sim::RadToDeg(agent::BearingOf(i)));
    std::string text = fmt::format("{}°", degrees);
    if (degrees == 0) text = "ahead";
    if (std::abs(degrees) == 90) text = degrees > 0 ? "left" : "right";
    if (degrees == 180) text = "behind";
    canvas_->Text({At(i), y}, text, {.size = kSmall, .paint = kInk});
  }
}

void DirectionStrip::Axis(const std::string& label, double top, double height) const {
  for (const double value : {0.0, 0.5, 1.0}) {
    const double y = top + height * (1.0 - value);
    canvas_->Line({left_, y}, {right(), y}, value == 0.0 ? 1.0 : 0.7, value == 0.0 ? kInk : kGrid);
    canvas_->Text({left_ - 5.0, y}, fmt::format("{:.1f}", value),
                  {.size = kSmall, .paint = kInk, .align = Align::kRight});
  }
  canvas_->Text({left_ - 36.0, top + 0.5 * height}, label,
                {.size = 11.0, .paint = kInk, .upwards = true});
}

void DirectionStrip::Bar(int direction, double value, double top, double height, int side,
                         const Paint& paint) const {
  const double half = (side == 0 ? 0.34 : 0.19) * cell();
  const double x = At(direction) + 0.2 * side * cell();
  const double tip = top + height * (1.0 - std::clamp(value, 0.0, 1.0));
  const std::array<Point, 4> corners = {Point(x - half, top + height), Point(x - half, tip),
                                        Point(x + half, tip), Point(x + half, top + height)};
  canvas_->Fill(corners, paint);
}

void DirectionStrip::Box(int direction, double top, double inset, const Stroke& stroke) const {
  const double x = At(direction);
  const double half = 0.5 * cell() - inset;
  const double bottom = top + panorama_height() - inset;
  const std::array<Point, 4> corners = {Point(x - half, top + inset), Point(x + half, top + inset),
                                        Point(x + half, bottom), Point(x - half, bottom)};
  canvas_->Outline(corners, {stroke.width + 2.0, kWhite.WithAlpha(0.7), {}});
  canvas_->Outline(corners, stroke);
}

void DrawTip(const Point& tip, double size, const Paint& paint, Canvas* canvas) {
  const std::array<Point, 3> corners = {tip, tip + size * Point(0.7, 1.0),
                                        tip + size * Point(-0.7, 1.0)};
  canvas->Outline(corners, {3.0, kWhite, {}});
  canvas->Fill(corners, paint);
}

void DrawArrow(const Point& from, const Point& to, const Stroke& stroke, Canvas* canvas) {
  const Point way = to - from;
  const double length = way.norm();
  if (length < 1.0) return;
  const Point along = way / length;
  const Point aside(-along.y(), along.x());
  const double head = 3.5 * stroke.width + 3.0;
  const std::array<Point, 2> shaft = {from, to - 0.8 * head * along};
  canvas->Polyline(shaft, stroke);
  const std::array<Point, 3> tip = {to, to - head * along + 0.45 * head * aside,
                                    to - head * along - 0.45 * head * aside};
  canvas->Fill(tip, stroke.paint);
}

}  // namespace bulletnav::bench
