// SPDX-License-Identifier: MIT
#include "benchmark/report/trajectory_layers.h"

#include <algorithm>

#include "benchmark/report/goal_ends.h"
#include "benchmark/report/marks.h"
#include "benchmark/report/palette.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kPathWidth = 2.6;
constexpr double kRimWidth = 4.6;

}  // namespace

std::vector<sim::BodyPose> TruePoses(const EpisodeTrajectory& trajectory) {
  std::vector<sim::BodyPose> poses = {trajectory.start};
  for (const TrajectoryStep& step : trajectory.steps) poses.push_back(step.pose);
  return poses;
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
  const std::vector<int> numbers = StepNumbers(trajectory);
  const double last = std::max(1, numbers.back());
  for (std::size_t i = 0; i < poses.size() && i <= until; ++i) {
    const Point p = place.At(poses[i].position);
    if (!points.empty() && (p - points.back()).norm() < kStill) continue;
    points.push_back(p);
    paints.push_back(TimeColor(numbers[i] / last));
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

std::vector<Point> CollisionMarks(const EpisodeTrajectory& trajectory, const MapPlace& place) {
  constexpr double kApart = 12.0;  // two crosses and the path between them
  std::vector<Point> marks;
  for (const TrajectoryStep& step : trajectory.steps) {
    if (!step.collided) continue;
    const Point at = place.At(step.pose.position);
    const auto is_near = [&](const Point& other) {
      return (at - other).norm() < kApart;
    };
    if (std::none_of(marks.begin(), marks.end(), is_near)) marks.push_back(at);
  }
  return marks;
}

void DrawMarks(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas) {
  for (const Point& at : CollisionMarks(trajectory, place)) DrawCollision(at, canvas);
  const auto& goals = trajectory.goals;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    DrawGoal(place.At(goals[i].position), goals.size() > 1 ? std::to_string(i + 1) : "", canvas);
  }
  const Eigen::Vector3d ahead = trajectory.start.forward();
  DrawStart(place.At(trajectory.start.position), sim::Atan2(ahead.z(), ahead.x()), canvas);
  for (const GoalEnd& end : GoalEnds(trajectory)) {
    DrawEnd(place.At(end.pose.position), end.kind, canvas);
  }
}

}  // namespace bulletnav::bench
