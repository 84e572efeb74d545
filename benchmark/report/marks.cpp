// SPDX-License-Identifier: MIT
#include "benchmark/report/marks.h"

#include <vector>

#include <fmt/core.h>

#include "benchmark/report/palette.h"
#include "sim/base/elementary.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr Paint kGoal = {0.98, 0.80, 0.10};

Point Direction(double angle) {
  return {sim::Cos(angle), sim::Sin(angle)};
}

std::vector<Point> Polygon(const Point& centre, double radius, int corners, double first) {
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(corners));
  for (int i = 0; i < corners; ++i) {
    points.push_back(centre + radius * Direction(first + 2.0 * sim::kPi * i / corners));
  }
  return points;
}

void FillAndOutline(const std::vector<Point>& polygon, const Paint& fill, const Stroke& outline,
                    Canvas* canvas) {
  canvas->Fill(polygon, fill);
  canvas->Outline(polygon, outline);
}

void DrawTick(const Point& at, Canvas* canvas) {
  const std::vector<Point> tick = {at + Point(-2.7, 0.2), at + Point(-0.8, 2.3),
                                   at + Point(2.8, -2.2)};
  canvas->Polyline(tick, {1.5, kWhite, {}});
}

void DrawCross(const Point& at, Canvas* canvas) {
  canvas->Line(at + Point(-2.3, -2.3), at + Point(2.3, 2.3), 1.5, kWhite);
  canvas->Line(at + Point(-2.3, 2.3), at + Point(2.3, -2.3), 1.5, kWhite);
}

}  // namespace

void DrawStart(const Point& at, double heading, Canvas* canvas) {
  const Point ahead = Direction(heading);
  const Point aside(-ahead.y(), ahead.x());
  const std::vector<Point> tip = {at + 12.0 * ahead, at + 4.5 * aside + 5.0 * ahead,
                                  at - 4.5 * aside + 5.0 * ahead};
  FillAndOutline(tip, kInk, {1.0, kWhite, {}}, canvas);
  canvas->Disc(at, 6.5, kWhite);
  canvas->Ring(at, 5.2, {2.2, kInk, {}});
}

void DrawGoal(const Point& at, const std::string& number, Canvas* canvas) {
  const double radius = number.empty() ? 9.0 : 11.5;
  std::vector<Point> star;
  for (int i = 0; i < 10; ++i) {
    const double reach = i % 2 == 0 ? radius : (number.empty() ? 0.45 : 0.6) * radius;
    star.push_back(at + reach * Direction(sim::kPi * (0.2 * i - 0.5)));
  }
  canvas->Outline(star, {3.5, kWhite, {}});
  FillAndOutline(star, kGoal, {1.2, kInk, {}}, canvas);
  if (!number.empty()) {
    canvas->Text(at + Point(0.0, 0.6), number, {.size = 9.0, .paint = kBlack, .bold = true});
  }
}

void DrawEnd(const Point& at, EndKind kind, Canvas* canvas) {
  const Stroke rim = {1.4, kWhite, {}};
  const auto octagon = Polygon(at, 6.2, 8, sim::kPi / 8.0);
  switch (kind) {
    case EndKind::kStopAtGoal:
      FillAndOutline(octagon, kGreen, rim, canvas);
      DrawTick(at, canvas);
      return;
    case EndKind::kStopElsewhere:
      FillAndOutline(octagon, kVermillion, rim, canvas);
      DrawCross(at, canvas);
      return;
    case EndKind::kReached:
      FillAndOutline(Polygon(at, 5.6, 32, 0.0), kGreen, rim, canvas);
      DrawTick(at, canvas);
      return;
    case EndKind::kNoStop:
      FillAndOutline(Polygon(at, 7.0, 4, sim::kPi / 4.0), kInk, rim, canvas);
      return;
  }
}

void DrawCollision(const Point& at, Canvas* canvas) {
  constexpr double kArm = 2.4;
  for (const bool is_rim : {true, false}) {
    const double width = is_rim ? 2.2 : 1.1;
    const Paint paint = is_rim ? kWhite.WithAlpha(0.6) : kVermillion;
    canvas->Line(at + Point(-kArm, -kArm), at + Point(kArm, kArm), width, paint);
    canvas->Line(at + Point(-kArm, kArm), at + Point(kArm, -kArm), width, paint);
  }
}

void DrawTarget(const Point& at, Canvas* canvas) {
  FillAndOutline(Polygon(at, 5.5, 4, 0.0), kWhite, {1.6, kPurple, {}}, canvas);
}

void DrawNode(const Point& at, bool is_ghost, Canvas* canvas) {
  canvas->Disc(at, is_ghost ? 2.8 : 4.0, is_ghost ? kWhite : kPurple);
  canvas->Ring(at, is_ghost ? 2.8 : 4.0, {1.2, is_ghost ? kPurple : kWhite, {}});
}

void DrawScores(std::span<const ScoreMark> scores, FreePlaces* places, Canvas* canvas) {
  const TextStyle style = {.size = 9.0, .paint = kPurple, .halo = true};
  for (const ScoreMark& mark : scores) {
    const std::string text = fmt::format("{:.2f}", mark.score);
    const Point size = canvas->TextSize(text, style.size, false) + Point(2.0, 2.0);
    const double aside = 5.0 + 0.5 * size.x();
    const double above = 4.0 + 0.5 * size.y();
    std::vector<Point> middles;
    for (const Point& off :
         {Point(aside, 0.0), Point(-aside, 0.0), Point(0.0, -above), Point(0.0, above),
          Point(aside, -above), Point(aside, above), Point(-aside, -above), Point(-aside, above)}) {
      middles.push_back(mark.node + off);
    }
    canvas->Text(places->Choose(middles, size), text, style);
  }
}

}  // namespace bulletnav::bench
