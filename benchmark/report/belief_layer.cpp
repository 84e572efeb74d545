// SPDX-License-Identifier: MIT
#include "benchmark/report/belief_layer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "benchmark/report/goal_ends.h"
#include "benchmark/report/marks.h"
#include "benchmark/report/palette.h"

namespace bulletnav::bench {
namespace {

using agent::GraphPicture;
using agent::MapPicture;
using Point = Canvas::Point;

// A stronger obstacle, told from the orange of paths and from the colours of time.
constexpr Paint kFeltWall = {0.72, 0.0, 0.36};
// In the order of MapPicture::Kind.
constexpr std::array<Paint, 4> kMapPaints = {Paint{0, 0, 0, 0}, kSkyBlue.WithAlpha(0.22),
                                             kPurple.WithAlpha(0.6), kFeltWall.WithAlpha(0.95)};

sim::Image ToPicture(const MapPicture& map) {
  sim::Image image(map.size, map.size, 4);
  for (std::size_t i = 0; i < map.kinds.size(); ++i) {
    const Paint paint = MapPaint(map.kinds[i]);
    const std::array channels = {paint.red, paint.green, paint.blue, paint.alpha};
    std::transform(channels.begin(), channels.end(), &image.pixels[4 * i], [](double value) {
      return static_cast<std::uint8_t>(std::lround(255.0 * value));
    });
  }
  return image;
}

/// From the agent's plane to the canvas.
Eigen::Affine2d PlanePlace(const sim::BodyPose& start, const MapPlace& place) {
  const Point origin = place.At(start.position);
  Eigen::Affine2d affine;
  affine.translation() = origin;
  affine.linear().col(0) = place.At(start.position + start.forward()) - origin;
  affine.linear().col(1) = place.At(start.position + start.left()) - origin;
  return affine;
}

/// From the map's cells to the canvas.
Eigen::Affine2d CellPlace(const MapPicture& map, const Eigen::Affine2d& plane) {
  return plane * Eigen::Translation2d(map.low_x, map.low_y) * Eigen::Scaling(map.cell);
}

/// The path that the agent is on. Older recordings hold one also where it had left it for another
/// target.
std::vector<GraphPicture::Node> PathOf(const agent::Belief& belief) {
  constexpr double kSame = 0.01;  // metres
  std::vector<GraphPicture::Node> path;
  for (const int i : belief.graph->path) {
    path.push_back(belief.graph->nodes[static_cast<std::size_t>(i)]);
  }
  const auto is_target = [&](const GraphPicture::Node& node) {
    return std::hypot(node.x - belief.target->x, node.y - belief.target->y) < kSame;
  };
  if (path.size() < 2 || (belief.target && std::none_of(path.begin(), path.end(), is_target))) {
    return {};
  }
  return path;
}

Point At(const GraphPicture::Node& node, const Eigen::Affine2d& plane) {
  return plane * Point(node.x, node.y);
}

void DrawEdges(const agent::Belief& belief, const Eigen::Affine2d& plane, Canvas* canvas) {
  const GraphPicture& graph = *belief.graph;
  for (const auto& [from, to] : graph.edges) {
    canvas->Line(At(graph.nodes[static_cast<std::size_t>(from)], plane),
                 At(graph.nodes[static_cast<std::size_t>(to)], plane), 1.4, kPurple);
  }
  std::vector<Point> path;
  for (const GraphPicture::Node& node : PathOf(belief)) path.push_back(At(node, plane));
  canvas->Polyline(path, GraphPathStroke());
}

void DrawNodes(const GraphPicture& graph, const Eigen::Affine2d& plane, FreePlaces* places,
               Canvas* canvas) {
  std::vector<ScoreMark> scores;
  for (const auto& node : graph.nodes) {
    const Point at = At(node, plane);
    DrawNode(at, node.is_ghost, canvas);
    places->Take(at, Point(8.0, 8.0));
    if (node.score) scores.push_back({at, *node.score});
  }
  DrawScores(scores, places, canvas);
}

/// Which kinds of places a map shows within a box.
std::array<bool, 4> ShownKinds(const MapPicture& map, const Eigen::Affine2d& cells,
                               const Eigen::AlignedBox2d& box) {
  std::array<bool, 4> shown = {};
  const auto size = static_cast<std::size_t>(map.size);
  for (std::size_t i = 0; i < map.kinds.size(); ++i) {
    const auto kind = static_cast<std::size_t>(map.kinds[i]);
    if (shown[kind] || map.kinds[i] == MapPicture::Kind::kUnknown) continue;
    const std::size_t row = i / size;
    const Point middle(static_cast<double>(i % size) + 0.5, static_cast<double>(row) + 0.5);
    shown[kind] = box.contains(Point(cells * middle));
  }
  return shown;
}

}  // namespace

void DrawBelief(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas) {
  const agent::Belief& belief = trajectory.belief;
  const Eigen::Affine2d plane = PlanePlace(trajectory.start, place);
  canvas->Clip(place.box());
  if (belief.map) canvas->Picture(ToPicture(*belief.map), CellPlace(*belief.map, plane), false);
  if (belief.graph) DrawEdges(belief, plane, canvas);
  canvas->Unclip();
}

void DrawBeliefMarks(const SceneMap& scene, const EpisodeTrajectory& trajectory,
                     const MapPlace& place, Canvas* canvas) {
  const agent::Belief& belief = trajectory.belief;
  const Eigen::Affine2d plane = PlanePlace(trajectory.start, place);
  canvas->Clip(place.box());
  FreePlaces places(place.box());
  for (const Eigen::AlignedBox2d& name : RoomNameBoxes(scene, place, *canvas)) places.Take(name);
  places.Take(place.At(trajectory.start.position), Point(14.0, 14.0));
  for (const auto& goal : trajectory.goals) places.Take(place.At(goal.position), Point(20.0, 20.0));
  for (const GoalEnd& end : GoalEnds(trajectory)) {
    places.Take(place.At(end.pose.position), Point(14.0, 14.0));
  }
  if (belief.graph) DrawNodes(*belief.graph, plane, &places, canvas);
  if (belief.target) DrawTarget(plane * Point(belief.target->x, belief.target->y), canvas);
  canvas->Unclip();
}

ShownBelief ShownOf(const EpisodeTrajectory& trajectory, const MapPlace& place) {
  const agent::Belief& belief = trajectory.belief;
  const Eigen::Affine2d plane = PlanePlace(trajectory.start, place);
  const auto is_shown = [&](double x, double y) {
    return place.box().contains(Point(plane * Point(x, y)));
  };
  ShownBelief shown;
  if (belief.map) shown.map = ShownKinds(*belief.map, CellPlace(*belief.map, plane), place.box());
  if (belief.target) shown.target = is_shown(belief.target->x, belief.target->y);
  if (!belief.graph) return shown;
  for (const GraphPicture::Node& node : belief.graph->nodes) {
    if (!is_shown(node.x, node.y)) continue;
    (node.is_ghost ? shown.ghosts : shown.nodes) = true;
    shown.scores = shown.scores || node.score;
  }
  const auto path = PathOf(belief);
  shown.path = std::any_of(path.begin(), path.end(), [&](const GraphPicture::Node& node) {
    return is_shown(node.x, node.y);
  });
  return shown;
}

Paint MapPaint(MapPicture::Kind kind) {
  return kMapPaints[static_cast<std::size_t>(kind)];
}

Stroke GraphPathStroke() {
  return {3.2, kOrange, {}};
}

}  // namespace bulletnav::bench
