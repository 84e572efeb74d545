// SPDX-License-Identifier: MIT
#include "benchmark/report/trajectory_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "benchmark/report/goal_ends.h"
#include "benchmark/report/marks.h"
#include "benchmark/report/palette.h"
#include "benchmark/report/trajectory_layers.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kMargin = 10.0;
constexpr double kColumn = 205.0;  // width of what stands beside the map
constexpr double kLine = 15.0;     // from line to line of text
constexpr double kText = 11.0;
constexpr double kBarHeight = 100.0;
constexpr double kSign = 26.0;  // width of the signs in the legend
constexpr int kBarSteps = 50;

constexpr std::array<std::pair<EndKind, const char*>, 4> kEndTexts = {
    {{EndKind::kStopAtGoal, "stop at the goal"},
     {EndKind::kStopElsewhere, "stop elsewhere"},
     {EndKind::kReached, "goal reached"},
     {EndKind::kNoStop, "end without stop"}}};

/// The column of text, colour bar and legend, from the top down.
class SideColumn {
 public:
  SideColumn(const Point& corner, Canvas* canvas) : at_(corner), canvas_(canvas) {}

  void Title(const std::string& text) {
    canvas_->Text(at_ + Point(0.0, 7.0), text,
                  {.size = FittingSize(text, 13.0, true),
                   .paint = kInk,
                   .bold = true,
                   .align = Align::kLeft});
    at_.y() += kLine + 3.0;
  }

  void Line(const std::string& text) { TextAt(at_.x(), text); }

  void Gap() { at_.y() += 8.0; }

  /// Colours against steps.
  void TimeBar(int steps) {
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

  /// A line of the legend: `draw` gets the middle of the sign's place.
  template <class Draw>
  void Entry(const std::string& text, const Draw& draw) {
    draw(at_ + Point(0.5 * kSign, 0.5 * kLine));
    at_.y() += 2.0;
    TextAt(at_.x() + kSign + 8.0, text);
    at_.y() += 2.0;
  }

  void LineEntry(const std::string& text, const Stroke& stroke) {
    Entry(text, [&](const Point& p) {
      const Point half(0.5 * kSign, 0.0);
      canvas_->Polyline(std::vector<Point>{p - half, p + half}, stroke);
    });
  }

  double bottom() const { return at_.y(); }

 private:
  /// Long names and failures are printed smaller.
  double FittingSize(const std::string& text, double size, bool bold) const {
    const double width = canvas_->TextSize(text, size, bold).x();
    return size * std::min(1.0, (kColumn - kMargin) / std::max(1.0, width));
  }

  void TextAt(double x, const std::string& text) {
    canvas_->Text({x, at_.y() + 0.4 * kLine}, text,
                  {.size = FittingSize(text, kText, false), .paint = kInk, .align = Align::kLeft});
    at_.y() += kLine;
  }

  Point at_;
  Canvas* canvas_;
};

void DrawPathSign(const Point& p, Canvas* canvas) {
  constexpr int kPieces = 13;
  for (int i = 0; i < kPieces; ++i) {
    const double x = p.x() - 0.5 * kSign + kSign * i / kPieces;
    canvas->Line({x, p.y()}, {x + kSign / kPieces, p.y()}, 2.6, TimeColor((i + 0.5) / kPieces));
  }
}

void DrawBox(const Point& p, const Paint& paint, Canvas* canvas) {
  const Point half(7.0, 4.5);
  const std::vector<Point> box = {p - half, p + Point(half.x(), -half.y()), p + half,
                                  p + Point(-half.x(), half.y())};
  canvas->Fill(box, paint);
}

void AddBeliefEntries(const agent::Belief& belief, SideColumn* column, Canvas* canvas) {
  const auto box = [&](const char* text, const Paint& paint) {
    column->Entry(text, [&](const Point& p) {
      DrawBox(p, paint, canvas);
    });
  };
  if (belief.map) {
    box("its map: free", kSkyBlue.WithAlpha(0.35));
    box("its map: obstacle", kPurple.WithAlpha(0.6));
    box("its map: felt wall", kOrange);
  }
  if (belief.graph) {
    column->Entry("its graph, ghosts, scores", [&](const Point& p) {
      DrawNode(p - Point(7.0, 0.0), false, canvas);
      DrawNode(p + Point(7.0, 0.0), true, canvas);
    });
    if (belief.graph->path.size() > 1) column->LineEntry("chosen path", GraphPathStroke());
  }
  if (belief.target) {
    column->Entry("its last target", [&](const Point& p) {
      DrawTarget(p, canvas);
    });
  }
}

void AddLegend(const EpisodeTrajectory& trajectory, SideColumn* column, Canvas* canvas) {
  column->Entry("true path", [&](const Point& p) {
    DrawPathSign(p, canvas);
  });
  column->LineEntry("path by odometry", OdometryStroke());
  column->LineEntry("shortest path", ShortestPathStroke());
  column->Entry("start", [&](const Point& p) {
    DrawStart(p - Point(3.0, 0.0), 0.0, canvas);
  });
  column->Entry(trajectory.goals.size() > 1 ? "goals" : "goal", [&](const Point& p) {
    DrawGoal(p, "", canvas);
  });
  const std::vector<GoalEnd> ends = GoalEnds(trajectory);
  for (const auto& [kind, text] : kEndTexts) {
    if (std::none_of(ends.begin(), ends.end(), [kind = kind](const GoalEnd& end) {
          return end.kind == kind;
        })) {
      continue;
    }
    column->Entry(text, [&, kind = kind](const Point& p) {
      DrawEnd(p, kind, canvas);
    });
  }
  const auto is_collision = [](const TrajectoryStep& step) {
    return step.collided;
  };
  if (std::any_of(trajectory.steps.begin(), trajectory.steps.end(), is_collision)) {
    column->Entry("collision", [&](const Point& p) {
      DrawCollision(p, canvas);
    });
  }
}

/// Draws the column and returns where it ends.
double DrawColumn(const EpisodeTrajectory& trajectory, bool belief, const Point& corner,
                  Canvas* canvas) {
  SideColumn column(corner, canvas);
  column.Title(trajectory.result.key.agent);
  for (const std::string& line : OutcomeLines(trajectory)) column.Line(line);
  column.Gap();
  column.TimeBar(static_cast<int>(trajectory.steps.size()));
  AddLegend(trajectory, &column, canvas);
  if (belief) AddBeliefEntries(trajectory.belief, &column, canvas);
  return column.bottom();
}

/// "1 step", "2 steps".
std::string Count(int number, const char* what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

/// "success, SPL 0.73", or why there is none.
std::string Verdict(const EpisodeTrajectory& trajectory) {
  const auto& goals = trajectory.result.goals;
  if (!trajectory.result.failure.empty()) return "failed: " + trajectory.result.failure;
  if (goals.size() > 1) {
    double spl = 0.0;
    for (const GoalMetrics& goal : goals) spl += goal.spl / static_cast<double>(goals.size());
    const auto reached = std::count_if(goals.begin(), goals.end(), [](const GoalMetrics& goal) {
      return goal.success;
    });
    return fmt::format("{} of {} goals, SPL {:.2f}", reached, goals.size(), spl);
  }
  if (goals.front().success) return fmt::format("success, SPL {:.2f}", goals.front().spl);
  if (!std::isfinite(goals.front().distance_to_goal)) return "failed, cut off from the goal";
  return fmt::format("failed, {:.1f} m from the goal", goals.front().distance_to_goal);
}

}  // namespace

std::vector<std::string> OutcomeLines(const EpisodeTrajectory& trajectory) {
  const EpisodeResult& result = trajectory.result;
  double path = 0.0;
  double shortest = 0.0;
  int steps = 0;
  int collisions = 0;
  for (const GoalMetrics& goal : result.goals) {
    path += goal.path_length;
    shortest += goal.start_distance;
    steps += goal.steps;
    collisions += goal.collisions;
  }
  const std::string difficulty =
      result.difficulty ? fmt::format(" ({})", DifficultyName(*result.difficulty)) : "";
  // Generated episodes have their scene in their name.
  const std::string scene = std::filesystem::path(result.key.scene).stem().string();
  const std::string name = result.key.episode.starts_with(scene)
                               ? result.key.episode
                               : fmt::format("{}, episode {}", scene, result.key.episode);
  return {fmt::format("{}, {}, seed {}", result.key.setting, result.key.condition, result.key.seed),
          name + difficulty, Verdict(trajectory),
          fmt::format("{}, {}", Count(steps, "step"), Count(collisions, "collision")),
          fmt::format("walked {:.1f} m, shortest {:.1f} m", path, shortest)};
}

Figure TrajectoryPlot(const SceneMap& map, const EpisodeTrajectory& trajectory,
                      const TrajectoryPlotSpec& spec) {
  const Point size = FittingSize(map, {spec.map_width, spec.map_height});
  const Point corner(2.0 * kMargin + size.x(), kMargin);
  Canvas measure(1, 1, kWhite);
  const double column = DrawColumn(trajectory, spec.belief, corner, &measure) + kMargin;
  const auto shared =
      std::make_shared<const std::pair<SceneMap, EpisodeTrajectory>>(map, trajectory);
  Figure figure;
  figure.width = static_cast<int>(std::ceil(corner.x() + kColumn));
  figure.height = static_cast<int>(std::ceil(std::max(size.y() + 2.0 * kMargin, column)));
  const Eigen::AlignedBox2d box(Point(kMargin, kMargin),
                                Point(kMargin + size.x(), figure.height - kMargin));
  figure.draw = [shared, box, corner, belief = spec.belief](Canvas* canvas) {
    const auto& [scene, episode] = *shared;
    const MapPlace place(scene, box);
    DrawSceneMap(scene, place, canvas);
    if (belief) DrawBelief(episode, place, canvas);
    DrawShortestPath(episode, place, canvas);
    DrawTruePath(episode, episode.steps.size(), place, canvas);
    DrawOdometry(episode, place, canvas);
    DrawMarks(episode, place, canvas);
    DrawColumn(episode, belief, corner, canvas);
  };
  return figure;
}

}  // namespace bulletnav::bench
