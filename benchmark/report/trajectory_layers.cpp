// SPDX-License-Identifier: MIT
#include "benchmark/report/trajectory_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "benchmark/report/goal_ends.h"
#include "benchmark/report/marks.h"
#include "benchmark/report/palette.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kPathWidth = 2.6;
constexpr double kRimWidth = 4.6;

// Of what the agent's map says a place is, in the order of MapPicture::Kind.
constexpr std::array<Paint, 4> kMapPaints = {Paint{0, 0, 0, 0}, kSkyBlue, kPurple, kOrange};
constexpr std::array<double, 4> kMapOpacities = {0.0, 0.22, 0.6, 0.95};

sim::Image ToPicture(const agent::MapPicture& map) {
  sim::Image image(map.size, map.size, 4);
  for (std::size_t i = 0; i < map.kinds.size(); ++i) {
    const auto kind = static_cast<std::size_t>(map.kinds[i]);
    const Paint& paint = kMapPaints[kind];
    const std::array channels = {paint.red, paint.green, paint.blue, kMapOpacities[kind]};
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

void DrawGraph(const agent::GraphPicture& graph, const Eigen::Affine2d& plane, Canvas* canvas) {
  const auto at = [&](const agent::GraphPicture::Node& node) -> Point {
    return plane * Point(node.x, node.y);
  };
  for (const auto& [from, to] : graph.edges) {
    canvas->Line(at(graph.nodes[static_cast<std::size_t>(from)]),
                 at(graph.nodes[static_cast<std::size_t>(to)]), 1.4, kPurple);
  }
  std::vector<Point> path;
  for (const int i : graph.path) path.push_back(at(graph.nodes[static_cast<std::size_t>(i)]));
  canvas->Polyline(path, GraphPathStroke());
  for (const auto& node : graph.nodes) {
    DrawNode(at(node), node.is_ghost, canvas);
    if (node.score) DrawScore(at(node), *node.score, canvas);
  }
}

}  // namespace

std::vector<sim::BodyPose> TruePoses(const EpisodeTrajectory& trajectory) {
  std::vector<sim::BodyPose> poses = {trajectory.start};
  for (const TrajectoryStep& step : trajectory.steps) poses.push_back(step.pose);
  return poses;
}

void DrawBelief(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas) {
  const agent::Belief& belief = trajectory.belief;
  const Eigen::Affine2d plane = PlanePlace(trajectory.start, place);
  canvas->Clip(place.box());
  if (belief.map) {
    const agent::MapPicture& map = *belief.map;
    const Eigen::Affine2d cells =
        plane * Eigen::Translation2d(map.low_x, map.low_y) * Eigen::Scaling(map.cell);
    canvas->Picture(ToPicture(map), cells, false);
  }
  if (belief.graph) DrawGraph(*belief.graph, plane, canvas);
  if (belief.target) DrawTarget(plane * Point(belief.target->x, belief.target->y), canvas);
  canvas->Unclip();
}

Stroke GraphPathStroke() {
  return {3.2, kOrange, {}};
}

Stroke OdometryStroke() {
  return {1.2, kBlack, {4.0, 2.5}};
}

Stroke ShortestPathStroke() {
  return {2.0, kVermillion, {7.0, 3.0}};
}

void DrawShortestPath(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas) {
  std::vector<Point> points;
  for (const Eigen::Vector3d& p : trajectory.shortest_path) points.push_back(place.At(p));
  canvas->Polyline(points, {kRimWidth, kWhite.WithAlpha(0.7), {}});
  canvas->Polyline(points, ShortestPathStroke());
}

void DrawTruePath(const EpisodeTrajectory& trajectory, std::size_t until, const MapPlace& place,
                  Canvas* canvas) {
  constexpr double kStill = 0.2;  // pixels: turns on the spot add nothing to see
  std::vector<Point> points;
  std::vector<Paint> paints;
  const std::vector<sim::BodyPose> poses = TruePoses(trajectory);
  for (std::size_t i = 0; i < poses.size() && i <= until; ++i) {
    const Point p = place.At(poses[i].position);
    if (!points.empty() && (p - points.back()).norm() < kStill) continue;
    points.push_back(p);
    paints.push_back(TimeColor(static_cast<double>(i) / static_cast<double>(poses.size())));
  }
  canvas->Polyline(points, {kRimWidth, kWhite.WithAlpha(0.85), {}});
  for (std::size_t i = 1; i < points.size(); ++i) {
    canvas->Line(points[i - 1], points[i], kPathWidth, paints[i]);
  }
}

void DrawOdometry(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas) {
  std::vector<Point> points = {place.At(trajectory.start.position)};
  for (const TrajectoryStep& step : trajectory.steps) {
    points.push_back(place.At(sim::Apply(trajectory.start, step.odometry).position));
  }
  canvas->Clip(place.box());
  canvas->Polyline(points, OdometryStroke());
  canvas->Unclip();
}

void DrawMarks(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas) {
  const auto& steps = trajectory.steps;
  for (const TrajectoryStep& step : steps) {
    if (step.collided) DrawCollision(place.At(step.pose.position), canvas);
  }
  const auto& goals = trajectory.goals;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    DrawGoal(place.At(goals[i].position), goals.size() > 1 ? std::to_string(i + 1) : "", canvas);
  }
  const Eigen::Vector3d ahead = trajectory.start.forward();
  DrawStart(place.At(trajectory.start.position), std::atan2(ahead.z(), ahead.x()), canvas);
  for (const GoalEnd& end : GoalEnds(trajectory)) {
    DrawEnd(place.At(end.pose.position), end.kind, canvas);
  }
}

}  // namespace bulletnav::bench
