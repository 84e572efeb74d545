// SPDX-License-Identifier: MIT
#include "benchmark/report/animation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "benchmark/report/belief_layer.h"
#include "benchmark/report/filmstrip.h"
#include "benchmark/report/goal_ends.h"
#include "benchmark/report/marks.h"
#include "benchmark/report/palette.h"
#include "benchmark/report/replay.h"
#include "benchmark/report/trajectory_layers.h"
#include "benchmark/report/trajectory_plot.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kMargin = 12.0;
constexpr double kLine = 18.0;
constexpr double kTextSize = 12.0;

/// What all frames are drawn from.
class Animation {
 public:
  Animation(const sim::World& world, const SceneMap& map, const EpisodeTrajectory& trajectory,
            const AnimationSpec& spec)
      : map_(map),
        spec_(spec),
        drawn_(trajectory),
        poses_(TruePoses(trajectory)),
        numbers_(StepNumbers(trajectory)) {
    for (const sim::BodyPose& goal : trajectory.goals) {
      goals_.push_back(LookFrom(world, trajectory.body, spec.panorama, goal));
    }
    picture_size_ = {spec.panorama_width,
                     std::round(spec.panorama_width * spec.panorama.rows / spec.panorama.cols)};
    const Point map_size = FittingSize(map, {spec.map_width, spec.map_height});
    const Point corner(2.0 * kMargin + picture_size_.x(), kMargin);
    map_box_ = {corner, corner + map_size};
    const double lines = static_cast<double>(OutcomeLines(trajectory).size()) + 1.5;
    const double column = 2.0 * (picture_size_.y() + kLine) + lines * kLine;
    size_ = {corner.x() + map_size.x() + kMargin, 2.0 * kMargin + std::max(column, map_size.y())};
  }

  /// After so many actions.
  sim::Image Frame(std::size_t actions, const sim::Image& seen) {
    Canvas canvas(static_cast<int>(std::lround(size_.x())),
                  static_cast<int>(std::lround(size_.y())), kWhite, Canvas::Kind::kPixels,
                  spec_.scale);
    const std::size_t goal = GoalAt(drawn_, actions);
    const std::string which =
        goals_.size() > 1 ? fmt::format("goal {} of {}", goal + 1, goals_.size()) : "goal";
    double y = kMargin;
    y = DrawPicture(goals_[goal], which, y, &canvas);
    y = DrawPicture(seen, CaptionOf(actions), y, &canvas);
    DrawText(actions, y, &canvas);
    DrawMap(actions, &canvas);
    return canvas.ToImage();
  }

 private:
  /// With its caption above; returns where the next thing may stand.
  double DrawPicture(const sim::Image& image, const std::string& caption, double y,
                     Canvas* canvas) const {
    canvas->Text({kMargin, y + 0.45 * kLine}, caption,
                 {.size = kTextSize, .paint = kInk, .bold = true, .align = Align::kLeft});
    const Point corner(kMargin, y + kLine);
    const double zoom = picture_size_.x() / image.width;
    canvas->Picture(image, Eigen::Translation2d(corner) * Eigen::Scaling(zoom), true);
    return corner.y() + picture_size_.y() + 4.0;
  }

  std::string CaptionOf(std::size_t actions) const {
    if (actions == 0) return "seen at the start";
    std::string action(sim::ActionName(drawn_.steps[actions - 1].action));
    std::replace(action.begin(), action.end(), '_', ' ');
    return fmt::format("seen after step {}: {}", numbers_[actions], action);
  }

  void DrawText(std::size_t actions, double y, Canvas* canvas) const {
    TextStyle style = {.size = 14.0, .paint = kInk, .bold = true, .align = Align::kLeft};
    y += 0.75 * kLine;
    canvas->Text({kMargin, y}, spec_.title.empty() ? drawn_.result.key.agent : spec_.title, style);
    if (actions < drawn_.steps.size()) return;
    style = {.size = kTextSize, .paint = kInk, .align = Align::kLeft};
    for (const std::string& line : OutcomeLines(drawn_)) {
      y += kLine;
      canvas->Text({kMargin, y}, line, style);
    }
  }

  void DrawMap(std::size_t actions, Canvas* canvas) {
    const MapPlace place(map_, map_box_);
    DrawSceneMap(map_, place, canvas);
    const bool believes = spec_.belief && !drawn_.steps.empty();
    if (believes) {
      drawn_.belief = spec_.belief(std::min(actions, drawn_.steps.size() - 1));
      DrawBelief(drawn_, place, canvas);
    }
    DrawTruePath(drawn_, actions, place, canvas);
    if (believes) DrawBeliefMarks(map_, drawn_, place, canvas);
    const std::size_t goal = GoalAt(drawn_, actions);
    DrawGoal(place.At(drawn_.goals[goal].position),
             goals_.size() > 1 ? std::to_string(goal + 1) : "", canvas);
    for (const GoalEnd& end : GoalEnds(drawn_)) {
      if (end.actions <= actions) DrawEnd(place.At(end.pose.position), end.kind, canvas);
    }
    DrawBody(poses_[actions], place, canvas);
  }

  static void DrawBody(const sim::BodyPose& pose, const MapPlace& place, Canvas* canvas) {
    const Eigen::Vector3d ahead = pose.forward();
    DrawStart(place.At(pose.position), sim::Atan2(ahead.z(), ahead.x()), canvas);
  }

  const SceneMap& map_;
  const AnimationSpec& spec_;
  EpisodeTrajectory drawn_;  // with the belief of the frame
  std::vector<sim::BodyPose> poses_;
  std::vector<int> numbers_;
  std::vector<sim::Image> goals_;
  Point picture_size_;
  Point size_;
  Eigen::AlignedBox2d map_box_;
};

}  // namespace

std::vector<AnimationFrame> EpisodeAnimation(const std::shared_ptr<const sim::World>& world,
                                             const SceneMap& map,
                                             const EpisodeTrajectory& trajectory,
                                             const AnimationSpec& spec) {
  const std::vector<int> steps = FilmSteps(trajectory.steps.size(), spec.frames);
  const std::vector<sim::Image> seen = ReplayPanoramas(world, trajectory, spec.panorama, steps);
  Animation animation(*world, map, trajectory, spec);
  std::vector<AnimationFrame> frames;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    frames.push_back({animation.Frame(static_cast<std::size_t>(steps[i]), seen[i]), spec.frame_ms});
  }
  frames.back().milliseconds = spec.last_ms;
  return frames;
}

}  // namespace bulletnav::bench
