// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/example_figures.h"

#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "agent/perception/relative_pose.h"
#include "benchmark/evaluate_perception/direction_strip.h"
#include "benchmark/report/marks.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kLeft = 56.0;
constexpr double kStrip = 804.0;
constexpr double kWidth = kLeft + kStrip + 12.0;
constexpr double kTitle = 26.0;
constexpr double kBars = 84.0;  // height of a row of bars
constexpr double kGap = 12.0;   // between rows
constexpr double kBearings = 18.0;
constexpr double kLegend = 24.0;
constexpr double kGoalWidth = 0.5 * (kStrip - kGap);
constexpr TextStyle kHead = {.size = 13.0, .paint = kInk, .bold = true, .align = Align::kLeft};
constexpr TextStyle kPlain = {.size = 11.5, .paint = kInk, .align = Align::kLeft};

/// "living room, house_068.glb".
std::string Whereabouts(const ExampleScene& scene, int place) {
  const std::string room = scene.RoomOf(place);
  const std::string file = scene.cases().scene.filename().string();
  return room.empty() ? file : room + ", " + file;
}

void Title(const std::string& text, const std::string& where, Canvas* canvas) {
  canvas->Text({kLeft, 0.5 * kTitle}, text, kHead);
  canvas->Text({kLeft + kStrip, 0.5 * kTitle}, where,
               {.size = 11.5, .paint = kInk, .align = Align::kRight});
}

/// Signs and what they mean, in a line.
class Legend {
 public:
  Legend(double y, Canvas* canvas) : at_(kLeft, y), canvas_(canvas) {}

  template <class F>
  void Entry(const std::string& text, const F& draw) {
    draw(at_ + Point(8.0, 0.0));
    canvas_->Text(at_ + Point(20.0, 0.0), text, kPlain);
    at_.x() += 44.0 + canvas_->TextSize(text, kPlain.size, false).x();
  }
  void Box(const std::string& text, const Paint& paint) {
    Entry(text, [&](const Point& p) {
      const std::array<Point, 4> corners = {p + Point(-6.0, -5.0), p + Point(6.0, -5.0),
                                            p + Point(6.0, 5.0), p + Point(-6.0, 5.0)};
      canvas_->Fill(corners, paint);
    });
  }

 private:
  Point at_;
  Canvas* canvas_;
};

void DrawBest(const Point& at, Canvas* canvas) {
  canvas->Disc(at, 5.5, kWhite);
  canvas->Disc(at, 4.3, kTruth);
}

/// What is drawn of a place's scores for one goal.
struct GoalScores {
  std::array<bool, agent::kDirections> is_explorable{};
  PerDirection said{};
  PerDirection truth{};
  Choice choice;
  std::string text;
  sim::Image panorama;
};

GoalScores ScoresFor(ExampleScene* scene, int source, int goal) {
  const SceneCases& cases = scene->cases();
  GoalScores scores;
  scores.said = cases.prediction(source, goal).score;
  for (int i = 0; i < agent::kDirections; ++i) {
    const auto direction = static_cast<std::size_t>(i);
    scores.is_explorable[direction] = cases.samples.IsExplorable(source, i);
    scores.truth[direction] = cases.samples.pair(source, goal).far_score(i);
  }
  scores.choice = ChoiceOf(cases, source, goal);
  const std::string room = scene->RoomOf(goal);
  scores.text = fmt::format(
      "{}{:.1f} m away in a straight line, walls between: {}", room.empty() ? "" : room + ", ",
      double{cases.samples.pair(source, goal).distance_m()}, cases.walls_between(source, goal));
  scores.panorama = scene->Panorama(goal);
  return scores;
}

void DrawScores(const GoalScores& scores, const DirectionStrip& strip, double top, Canvas* canvas) {
  for (int i = 0; i < agent::kDirections; ++i) {
    const auto direction = static_cast<std::size_t>(i);
    const double opacity = scores.is_explorable[direction] ? 1.0 : 0.18;
    strip.Bar(i, double{scores.said[direction]}, top, kBars, -1, kSaid.WithAlpha(opacity));
    strip.Bar(i, double{scores.truth[direction]}, top, kBars, 1, kTruth.WithAlpha(opacity));
  }
  if (scores.choice.said < 0) return;
  DrawTip({strip.At(scores.choice.said) - 0.2 * strip.cell(), top + kBars + 3.0}, 9.0, kSaid,
          canvas);
  DrawBest({strip.At(scores.choice.best) + 0.2 * strip.cell(), top + kBars + 8.0}, canvas);
}

}  // namespace

Choice ChoiceOf(const SceneCases& cases, int source, int goal) {
  const PerDirection& said = cases.prediction(source, goal).score;
  const PairLabel& truth = cases.samples.pair(source, goal);
  const auto score = [&](int direction) {
    return said[static_cast<std::size_t>(direction)];
  };
  Choice choice;
  for (int i = 0; i < agent::kDirections; ++i) {
    if (!cases.samples.IsExplorable(source, i)) continue;
    if (choice.said < 0 || score(i) > score(choice.said)) choice.said = i;
    if (choice.best < 0 || truth.far_score(i) > truth.far_score(choice.best)) choice.best = i;
  }
  return choice;
}

Figure ExplorableFigure(ExampleScene* scene, int place, double threshold) {
  const auto panorama = std::make_shared<const sim::Image>(scene->Panorama(place));
  const PerDirection said = scene->cases().explorable[static_cast<std::size_t>(place)];
  const unsigned truth = scene->cases().samples.explorable[static_cast<std::size_t>(place)];
  const std::string where = Whereabouts(*scene, place);
  const double bars = kTitle + 0.25 * kStrip + kGap;
  const double bearings = bars + kBars + 0.5 * kBearings + 16.0;
  Figure figure;
  figure.width = static_cast<int>(kWidth);
  figure.height = static_cast<int>(bearings + kBearings + kLegend);
  figure.draw = [=](Canvas* canvas) {
    const DirectionStrip strip(kLeft, kStrip, canvas);
    Title("Explorable directions", where, canvas);
    strip.Panorama(*panorama, kTitle);
    strip.Axis("probability", bars, kBars);
    for (int i = 0; i < agent::kDirections; ++i) {
      const auto probability = double{said[static_cast<std::size_t>(i)]};
      const bool is_yes = probability >= threshold;
      strip.Bar(i, probability, bars, kBars, 0, is_yes ? kSaid : kPale);
      const Point tip(strip.At(i), kTitle + strip.panorama_height() - 26.0);
      if (is_yes) DrawTip(tip, 18.0, kSaid, canvas);
      if (((truth >> i) & 1u) != 0) DrawBest({strip.At(i), bars + kBars + 9.0}, canvas);
    }
    const double y = bars + kBars * (1.0 - threshold);
    const std::array<Point, 2> line = {Point(strip.left(), y), Point(strip.right(), y)};
    canvas->Polyline(line, {1.0, kInk, {4.0, 3.0}});
    strip.Bearings(bearings);
    Legend legend(bearings + kBearings + 2.0, canvas);
    legend.Box("said to be explorable", kSaid);
    legend.Box("said not to be", kPale);
    legend.Entry("is explorable", [&](const Point& p) {
      DrawBest(p, canvas);
    });
  };
  return figure;
}

Figure ScoresFigure(ExampleScene* scene, int source, const std::vector<int>& goals) {
  const auto panorama = std::make_shared<const sim::Image>(scene->Panorama(source));
  const auto scores = std::make_shared<std::vector<GoalScores>>();
  for (const int goal : goals) scores->push_back(ScoresFor(scene, source, goal));
  const std::string where = Whereabouts(*scene, source);
  constexpr double kRow = kTitle + kBars + 18.0;
  constexpr double kGoalRow = kTitle + 0.25 * kGoalWidth;
  const double rows = kTitle + 0.25 * kStrip + kBearings;
  const double pictures = rows + kRow * static_cast<double>(goals.size()) + 4.0;
  const double goal_rows = std::ceil(0.5 * static_cast<double>(goals.size()));
  const double legend_y = pictures + kGoalRow * goal_rows + 0.5 * kLegend + 2.0;
  Figure figure;
  figure.width = static_cast<int>(kWidth);
  figure.height = static_cast<int>(legend_y + 0.5 * kLegend);
  figure.draw = [=](Canvas* canvas) {
    const DirectionStrip strip(kLeft, kStrip, canvas);
    Title("Scores of directions", where, canvas);
    strip.Panorama(*panorama, kTitle);
    strip.Bearings(rows - 0.5 * kBearings + 1.0);
    for (std::size_t g = 0; g < scores->size(); ++g) {
      const GoalScores& one = (*scores)[g];
      const double top = rows + kRow * static_cast<double>(g);
      const std::string name = fmt::format("Goal {}", static_cast<char>('A' + g));
      canvas->Text({kLeft, top + 0.5 * kTitle}, name, kHead);
      canvas->Text({kLeft + 52.0, top + 0.5 * kTitle}, one.text, kPlain);
      strip.Axis("score", top + kTitle, kBars);
      DrawScores(one, strip, top + kTitle, canvas);
      const double left = kLeft + (g % 2 == 0 ? 0.0 : kGoalWidth + kGap);
      const double goal_top = pictures + kGoalRow * std::floor(0.5 * static_cast<double>(g));
      canvas->Text({left, goal_top + 0.5 * kTitle}, name, kHead);
      DirectionStrip(left, kGoalWidth, canvas).Panorama(one.panorama, goal_top + kTitle);
    }
    Legend legend(legend_y, canvas);
    legend.Box("said", kSaid);
    legend.Box("true (pale: not explorable)", kTruth);
    legend.Entry("highest said, of explorable ones", [&](const Point& p) {
      DrawTip(p - Point(0.0, 4.5), 9.0, kSaid, canvas);
    });
    legend.Entry("truly best", [&](const Point& p) {
      DrawBest(p, canvas);
    });
  };
  return figure;
}

Figure RelativePoseFigure(ExampleScene* scene, int source, int goal) {
  const SceneCases& cases = scene->cases();
  const auto from = std::make_shared<const sim::Image>(scene->Panorama(source));
  const auto to = std::make_shared<const sim::Image>(scene->Panorama(goal));
  const agent::PairPrediction said = cases.prediction(source, goal);
  const agent::RelativeGoal there = agent::RelativePoseOf(said);
  const auto& poses = cases.samples.poses;
  const sim::PlanarPose truth = sim::RelativePose(poses[static_cast<std::size_t>(source)],
                                                  poses[static_cast<std::size_t>(goal)]);
  const double bearing = sim::Atan2(truth.y, truth.x);
  const std::string numbers = fmt::format(
      "distance {:.2f} m, truly {:.2f} m;  bearing {:.0f}°, truly {:.0f}°;  same node: {:.2f}",
      there.distance, std::hypot(truth.x, truth.y), sim::RadToDeg(there.bearing),
      sim::RadToDeg(bearing), double{said.same_node});
  const std::string where = Whereabouts(*scene, source);
  const double bars = kTitle + 0.25 * kStrip + kGap;
  const double bearings = bars + kBars + 0.5 * kBearings;
  const double goal_top = bearings + kBearings;
  Figure figure;
  figure.width = static_cast<int>(kWidth);
  figure.height = static_cast<int>(goal_top + kTitle + 0.25 * kStrip + kLegend + 4.0);
  figure.draw = [=](Canvas* canvas) {
    const DirectionStrip strip(kLeft, kStrip, canvas);
    Title("Where the goal is", where, canvas);
    strip.Panorama(*from, kTitle);
    strip.Axis("probability", bars, kBars);
    for (int i = 0; i < agent::kDirections; ++i) {
      strip.Bar(i, double{said.direction[static_cast<std::size_t>(i)]}, bars, kBars, 0, kSaid);
    }
    const auto mark = [&](double x, const Paint& paint, const std::vector<double>& dashes) {
      const std::array<Point, 2> line = {Point(x, kTitle), Point(x, bars + kBars)};
      canvas->Polyline(line, {4.5, kWhite.WithAlpha(0.7), {}});
      canvas->Polyline(line, {2.5, paint, dashes});
    };
    mark(strip.AtBearing(bearing), kTruth, {});
    mark(strip.AtBearing(there.bearing), kSaid, {7.0, 4.0});
    strip.Bearings(bearings);
    canvas->Text({kLeft, goal_top + 0.5 * kTitle}, "Goal", kHead);
    canvas->Text({kLeft + 40.0, goal_top + 0.5 * kTitle}, numbers, kPlain);
    strip.Panorama(*to, goal_top + kTitle);
    Legend legend(goal_top + kTitle + 0.25 * kStrip + 0.5 * kLegend + 2.0, canvas);
    legend.Box("probability of each direction, and (dashed) the bearing made of them", kSaid);
    legend.Box("true bearing", kTruth);
  };
  return figure;
}

}  // namespace bulletnav::bench
