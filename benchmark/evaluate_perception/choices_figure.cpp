// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "benchmark/evaluate_perception/direction_strip.h"
#include "benchmark/evaluate_perception/example_figures.h"
#include "benchmark/report/marks.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kMargin = 12.0;
constexpr double kMap = 470.0;        // width at most
constexpr double kMapHeight = 450.0;  // at most
constexpr double kStrip = 480.0;      // width of panoramas
constexpr double kCaption = 22.0;
constexpr double kBelow = 4.0;
constexpr double kRow = kCaption + 0.25 * kStrip + kBelow;
constexpr double kLegend = 64.0;

struct Source {
  sim::BodyPose pose;
  Choice choice;
  std::vector<Eigen::Vector3d> far;  // [directions]
  std::vector<int> explorable;
  std::string text;
  sim::Image panorama;
};

/// Everything the figure shows.
struct Choices {
  SceneMap map;
  std::vector<Source> sources;
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();
  std::string goal_text;
  sim::Image goal_panorama;
};

Source SourceOf(ExampleScene* scene, int place, int goal) {
  const SceneCases& cases = scene->cases();
  Source source;
  source.pose = cases.samples.poses[static_cast<std::size_t>(place)];
  source.choice = ChoiceOf(cases, place, goal);
  for (int i = 0; i < agent::kDirections; ++i) {
    source.far.push_back(cases.samples.FarPoint(place, i).position);
    if (cases.samples.IsExplorable(place, i)) source.explorable.push_back(i);
  }
  const PairLabel& truth = cases.samples.pair(place, goal);
  const double lost = agent::kFarthestScored * double{truth.far_score(source.choice.best) -
                                                      truth.far_score(source.choice.said)};
  source.text =
      lost < 0.05 ? "the shortest way" : fmt::format("{:.1f} m longer than need be", lost);
  source.panorama = scene->Panorama(place);
  return source;
}

class ChoicesDrawing {
 public:
  ChoicesDrawing(const Choices& choices, Canvas* canvas) : choices_(choices), canvas_(canvas) {}

  void Goal(double top, double width) const {
    Caption("Goal", choices_.goal_text, kMargin, top);
    DirectionStrip(kMargin, width, canvas_).Panorama(choices_.goal_panorama, top + kCaption);
  }

  /// `pitch`: from one to the next.
  void Panoramas(double left, double pitch) const {
    const DirectionStrip strip(left, kStrip, canvas_);
    double top = kMargin;
    int number = 1;
    for (const Source& source : choices_.sources) {
      Caption(fmt::format("Place {}", number++), source.text, left, top);
      strip.Panorama(source.panorama, top + kCaption);
      for (const int i : source.explorable) {
        DrawTip({strip.At(i), top + kCaption + strip.panorama_height() - 14.0}, 9.0, kPale,
                canvas_);
      }
      strip.Box(source.choice.best, top + kCaption, 1.5, {2.5, kTruth, {6.0, 4.0}});
      strip.Box(source.choice.said, top + kCaption, 4.5, {2.5, kSaid, {}});
      top += pitch;
    }
  }

  void Map(const Eigen::AlignedBox2d& box) const {
    const MapPlace place(choices_.map, box);
    DrawSceneMap(choices_.map, place, canvas_);
    for (const Source& source : choices_.sources) {
      const Point at = place.At(source.pose.position);
      const auto arrow = [&](int direction, const Stroke& stroke) {
        DrawArrow(at, place.At(source.far[static_cast<std::size_t>(direction)]), stroke, canvas_);
      };
      for (const int i : source.explorable) arrow(i, {1.2, kInk.WithAlpha(0.55), {}});
      arrow(source.choice.best, {4.2, kTruth, {}});
      arrow(source.choice.said, {2.0, kSaid, {}});
    }
    int number = 1;
    for (const Source& source : choices_.sources) {
      const Point at = place.At(source.pose.position);
      canvas_->Disc(at, 8.5, kWhite);
      canvas_->Ring(at, 7.5, {1.5, kInk, {}});
      canvas_->Text(at, std::to_string(number++), {.size = 10.0, .paint = kInk, .bold = true});
    }
    DrawGoal(place.At(choices_.goal), "", canvas_);
  }

  void Legend(double top) const {
    const auto line = [&](double y, const char* text, const Paint& paint, double width) {
      DrawArrow({kMargin, y}, {kMargin + 26.0, y}, {width, paint, {}}, canvas_);
      canvas_->Text({kMargin + 34.0, y}, text,
                    {.size = 11.5, .paint = kInk, .align = Align::kLeft});
    };
    line(top + 8.0, "direction with the highest score said", kSaid, 2.0);
    line(top + 26.0, "direction that leads to the goal soonest", kTruth, 4.2);
    line(top + 44.0, "other explorable directions", kInk.WithAlpha(0.55), 1.2);
  }

 private:
  void Caption(const std::string& head, const std::string& text, double left, double top) const {
    const Point at(left, top + 0.5 * kCaption);
    canvas_->Text(at, head, {.size = 13.0, .paint = kInk, .bold = true, .align = Align::kLeft});
    canvas_->Text(at + Point(56.0, 0.0), text,
                  {.size = 11.5, .paint = kInk, .align = Align::kLeft});
  }

  const Choices& choices_;
  Canvas* canvas_;
};

}  // namespace

Figure ChoicesFigure(ExampleScene* scene, const std::vector<int>& sources, int goal) {
  const auto choices = std::make_shared<Choices>();
  choices->map = scene->map();
  for (const int source : sources) choices->sources.push_back(SourceOf(scene, source, goal));
  choices->goal = scene->cases().samples.poses[static_cast<std::size_t>(goal)].position;
  const std::string room = scene->RoomOf(goal);
  const std::string file = scene->cases().scene.filename().string();
  choices->goal_text = room.empty() ? file : room + ", " + file;
  choices->goal_panorama = scene->Panorama(goal);
  const Point map = FittingSize(choices->map, {kMap, kMapHeight});
  const double column = std::max(map.x(), 380.0);
  const double goal_top = kMargin + map.y() + 14.0 + kLegend;
  const double strips = 2.0 * kMargin + column + kMargin;
  const double left_height = goal_top + kCaption + 0.25 * column;
  const double right_height = kMargin + kRow * static_cast<double>(sources.size()) - kBelow;
  const double height = std::max(left_height, right_height);
  // The last panorama ends where the goal's does.
  const double spare =
      (height - right_height) / std::max(1.0, static_cast<double>(sources.size()) - 1.0);
  const double pitch = kRow + spare;
  Figure figure;
  figure.width = static_cast<int>(strips + kStrip + kMargin);
  figure.height = static_cast<int>(height + kMargin);
  figure.draw = [=](Canvas* canvas) {
    const ChoicesDrawing drawing(*choices, canvas);
    const Point corner(kMargin + 0.5 * (column - map.x()), kMargin);
    drawing.Map({corner, corner + map});
    drawing.Legend(kMargin + map.y() + 14.0);
    drawing.Goal(goal_top, column);
    drawing.Panoramas(strips, pitch);
  };
  return figure;
}

}  // namespace bulletnav::bench
