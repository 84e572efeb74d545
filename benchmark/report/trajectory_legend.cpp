// SPDX-License-Identifier: MIT
#include "benchmark/report/trajectory_legend.h"

#include <algorithm>
#include <array>

#include "benchmark/play/condition.h"
#include "benchmark/report/belief_layer.h"
#include "benchmark/report/goal_ends.h"
#include "benchmark/report/marks.h"
#include "benchmark/report/palette.h"
#include "benchmark/report/trajectory_layers.h"

namespace bulletnav::bench {
namespace {

using Kind = agent::MapPicture::Kind;
using Point = Canvas::Point;

constexpr std::array kEndKinds = {EndKind::kStopAtGoal, EndKind::kStopElsewhere, EndKind::kReached,
                                  EndKind::kNoStop};

const char* EndText(EndKind kind, const EpisodeResult& result) {
  switch (kind) {
    case EndKind::kStopAtGoal:
      return "stop at the goal";
    case EndKind::kStopElsewhere:
      return "stop elsewhere";
    case EndKind::kReached:
      return "goal reached";
    case EndKind::kNoStop:
      if (result.key.condition != sim::NameOf(Condition::kNoStop)) return "end without stop";
      return result.failure.empty() ? "goal not reached in time" : "goal not reached";
  }
  return "";
}

LegendEntry LineEntry(const char* text, const Stroke& stroke) {
  return {text, [stroke](const Point& p, Canvas* canvas) {
            const Point half(0.5 * kSignWidth, 0.0);
            canvas->Polyline(std::vector<Point>{p - half, p + half}, stroke);
          }};
}

LegendEntry BoxEntry(const char* text, const Paint& paint) {
  return {text, [paint](const Point& p, Canvas* canvas) {
            const Point half(7.0, 4.5);
            const std::vector<Point> box = {p - half, p + Point(half.x(), -half.y()), p + half,
                                            p + Point(-half.x(), half.y())};
            canvas->Fill(box, paint);
          }};
}

void DrawPathSign(const Point& p, Canvas* canvas) {
  constexpr int kPieces = 13;
  for (int i = 0; i < kPieces; ++i) {
    const double x = p.x() - 0.5 * kSignWidth + kSignWidth * i / kPieces;
    canvas->Line({x, p.y()}, {x + kSignWidth / kPieces, p.y()}, 2.6,
                 TimeColor((i + 0.5) / kPieces));
  }
}

/// "its graph, ghosts, scores": those of them that are shown.
LegendEntry GraphEntry(const ShownBelief& shown) {
  std::string text = shown.nodes ? "its graph" : "";
  if (shown.ghosts) text += shown.nodes ? ", ghosts" : "its graph's ghosts";
  if (shown.scores) text += ", scores";
  return {text, [nodes = shown.nodes, ghosts = shown.ghosts](const Point& p, Canvas* canvas) {
            const Point aside(nodes && ghosts ? 7.0 : 0.0, 0.0);
            if (nodes) DrawNode(p - aside, false, canvas);
            if (ghosts) DrawNode(p + aside, true, canvas);
          }};
}

void AddBelief(const ShownBelief& shown, std::vector<LegendEntry>* entries) {
  const auto is_shown = [&](Kind kind) {
    return shown.map[static_cast<std::size_t>(kind)];
  };
  // On white it takes more to look as it does on the floor's tint.
  const Paint free = MapPaint(Kind::kFree).WithAlpha(0.35);
  if (is_shown(Kind::kFree)) entries->push_back(BoxEntry("its map: free", free));
  if (is_shown(Kind::kObstacle)) {
    entries->push_back(BoxEntry("its map: obstacle", MapPaint(Kind::kObstacle)));
  }
  if (is_shown(Kind::kFeltWall)) {
    entries->push_back(BoxEntry("its map: felt wall", MapPaint(Kind::kFeltWall)));
  }
  if (shown.nodes || shown.ghosts) entries->push_back(GraphEntry(shown));
  if (shown.path) entries->push_back(LineEntry("chosen path", GraphPathStroke()));
  if (shown.target) entries->push_back({"its last target", DrawTarget});
}

void AddPaths(const EpisodeTrajectory& trajectory, std::vector<LegendEntry>* entries) {
  const auto& steps = trajectory.steps;
  if (std::any_of(steps.begin(), steps.end(), [&](const TrajectoryStep& step) {
        return step.pose.position != trajectory.start.position;
      })) {
    entries->push_back({"true path", DrawPathSign});
  }
  if (std::any_of(steps.begin(), steps.end(), [](const TrajectoryStep& step) {
        return step.odometry.x != 0.0 || step.odometry.y != 0.0;
      })) {
    entries->push_back(LineEntry("path by odometry", OdometryStroke()));
  }
  if (trajectory.shortest_path.size() > 1) {
    const bool is_sequence = trajectory.goals.size() > 1;
    entries->push_back(LineEntry(is_sequence ? "shortest path, goal to goal" : "shortest path",
                                 ShortestPathStroke()));
  }
}

void AddMarks(const EpisodeTrajectory& trajectory, std::vector<LegendEntry>* entries) {
  entries->push_back({"start", [](const Point& p, Canvas* canvas) {
                        DrawStart(p - Point(3.0, 0.0), 0.0, canvas);
                      }});
  entries->push_back(
      {trajectory.goals.size() > 1 ? "goals" : "goal", [](const Point& p, Canvas* canvas) {
         DrawGoal(p, "", canvas);
       }});
  const std::vector<GoalEnd> ends = GoalEnds(trajectory);
  for (const EndKind kind : kEndKinds) {
    if (std::none_of(ends.begin(), ends.end(), [&](const GoalEnd& end) {
          return end.kind == kind;
        })) {
      continue;
    }
    entries->push_back({EndText(kind, trajectory.result), [kind](const Point& p, Canvas* canvas) {
                          DrawEnd(p, kind, canvas);
                        }});
  }
  const auto is_collision = [](const TrajectoryStep& step) {
    return step.collided;
  };
  const auto collisions =
      std::count_if(trajectory.steps.begin(), trajectory.steps.end(), is_collision);
  if (collisions > 0) {
    entries->push_back({collisions > 1 ? "collisions" : "collision", DrawCollision});
  }
}

}  // namespace

std::vector<LegendEntry> LegendOf(const EpisodeTrajectory& trajectory, const MapPlace& place,
                                  bool belief) {
  std::vector<LegendEntry> entries;
  AddPaths(trajectory, &entries);
  AddMarks(trajectory, &entries);
  if (belief) AddBelief(ShownOf(trajectory, place), &entries);
  return entries;
}

}  // namespace bulletnav::bench
