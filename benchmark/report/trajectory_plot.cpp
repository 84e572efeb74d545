// SPDX-License-Identifier: MIT
#include "benchmark/report/trajectory_plot.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/base/scene_names.h"
#include "benchmark/report/belief_layer.h"
#include "benchmark/report/goal_ends.h"
#include "benchmark/report/trajectory_layers.h"
#include "benchmark/report/trajectory_legend.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kMargin = 10.0;

/// Draws the column and returns where it ends.
double DrawColumn(const EpisodeTrajectory& trajectory, const MapPlace& place,
                  const TrajectoryPlotSpec& spec, const Point& corner, Canvas* canvas) {
  SideColumn column(corner, canvas);
  column.Title(spec.title.empty() ? trajectory.result.key.agent : spec.title);
  for (const std::string& line : OutcomeLines(trajectory)) column.Line(line);
  column.Gap();
  column.TimeBar(StepNumbers(trajectory).back());
  for (const LegendEntry& entry : LegendOf(trajectory, place, spec.belief)) column.Entry(entry);
  return column.bottom();
}

/// "success, SPL 0.73", or why there is none.
std::string Verdict(const EpisodeTrajectory& trajectory) {
  const auto& goals = trajectory.result.goals;
  if (!trajectory.result.failure.empty()) return "failed: " + trajectory.result.failure;
  const double spl = EpisodeValue(FindMeasure("spl"), goals).value_or(0.0);
  if (goals.size() > 1) {
    const auto reached = std::count_if(goals.begin(), goals.end(), [](const GoalMetrics& goal) {
      return goal.success();
    });
    return fmt::format("{} of {} goals, SPL {:.2f}", reached, goals.size(), spl);
  }
  if (goals.front().success()) return fmt::format("success, SPL {:.2f}", spl);
  const double left = goals.front().Value("distance_to_goal");
  if (!std::isfinite(left)) return "failed, cut off from the goal";
  return fmt::format("failed, {:.1f} m from the goal", left);
}

/// What was walked, and the shortest way: of all goals, or of several those that were reached, for
/// only there the two can be compared.
std::vector<std::string> DistanceLines(const std::vector<GoalMetrics>& goals) {
  double all = 0.0;
  double walked = 0.0;
  double shortest = 0.0;
  for (const GoalMetrics& goal : goals) {
    all += goal.Value("path_length");
    if (goals.size() > 1 && !goal.success()) continue;
    walked += goal.Value("path_length");
    shortest += goal.Value("start_distance");
  }
  if (goals.size() == 1) return {fmt::format("walked {:.1f} m, shortest {:.1f} m", all, shortest)};
  return {fmt::format("walked {:.1f} m in all", all),
          fmt::format("to goals reached {:.1f} m, shortest {:.1f} m", walked, shortest)};
}

}  // namespace

std::vector<std::string> OutcomeLines(const EpisodeTrajectory& trajectory) {
  const EpisodeResult& result = trajectory.result;
  int steps = 0;
  int collisions = 0;
  for (const GoalMetrics& goal : result.goals) {
    steps += goal.Whole("steps");
    collisions += goal.Whole("collisions");
  }
  const std::string difficulty =
      result.difficulty ? fmt::format(" ({})", DifficultyName(*result.difficulty)) : "";
  const std::string name = EpisodeName(result.key.scene, result.key.episode);
  std::vector<std::string> lines = {
      fmt::format("{}, {}, seed {}", result.key.setting, result.key.condition, result.key.seed),
      name + difficulty, Verdict(trajectory),
      fmt::format("{}, {}", Counted(static_cast<std::size_t>(steps), "step"),
                  Counted(static_cast<std::size_t>(collisions), "collision"))};
  for (std::string& line : DistanceLines(result.goals)) lines.push_back(std::move(line));
  return lines;
}

Figure TrajectoryPlot(const SceneMap& map, const EpisodeTrajectory& trajectory,
                      const TrajectoryPlotSpec& spec) {
  const Point size = FittingSize(map, {spec.map_width, spec.map_height});
  const Point corner(2.0 * kMargin + size.x(), kMargin);
  Canvas measure(1, 1, kWhite);
  const MapPlace any_place(map, {Point::Zero(), size});
  const double column = DrawColumn(trajectory, any_place, spec, corner, &measure) + kMargin;
  const auto shared =
      std::make_shared<const std::pair<SceneMap, EpisodeTrajectory>>(map, trajectory);
  Figure figure;
  figure.width = static_cast<int>(std::ceil(corner.x() + kSideColumnWidth));
  figure.height = static_cast<int>(std::ceil(std::max(size.y() + 2.0 * kMargin, column)));
  const Eigen::AlignedBox2d box(Point(kMargin, kMargin),
                                Point(kMargin + size.x(), figure.height - kMargin));
  figure.draw = [shared, box, corner, spec](Canvas* canvas) {
    const auto& [scene, episode] = *shared;
    const MapPlace place(scene, box);
    DrawSceneMap(scene, place, canvas);
    if (spec.belief) DrawBelief(episode, place, canvas);
    DrawShortestPath(episode, place, canvas);
    DrawTruePath(episode, episode.steps.size(), place, canvas);
    DrawOdometry(episode, place, canvas);
    if (spec.belief) DrawBeliefMarks(scene, episode, place, canvas);
    DrawMarks(episode, place, canvas);
    DrawColumn(episode, place, spec, corner, canvas);
  };
  return figure;
}

}  // namespace bulletnav::bench
