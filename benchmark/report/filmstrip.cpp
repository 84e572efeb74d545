// SPDX-License-Identifier: MIT
#include "benchmark/report/filmstrip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "benchmark/report/belief_layer.h"
#include "benchmark/report/free_places.h"
#include "benchmark/report/goal_ends.h"
#include "benchmark/report/palette.h"
#include "benchmark/report/replay.h"
#include "benchmark/report/trajectory_layers.h"
#include "benchmark/report/trajectory_plot.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kMargin = 12.0;
constexpr double kCaption = 20.0;  // height of a line of text over each picture
constexpr double kLine = 16.0;
constexpr double kTextSize = 11.0;
constexpr double kLeastMapHeight = 320.0;

/// A panorama: of a goal, or what the body saw.
struct Frame {
  bool is_goal = false;
  std::size_t number = 0;  // of the goal, or of Film::steps
  sim::Image image;
};

/// What a filmstrip is drawn from.
struct Film {
  SceneMap map;
  std::string title;
  EpisodeTrajectory trajectory;
  bool belief = false;
  std::vector<int> steps;  // actions taken before each view
  std::vector<Frame> frames;
  Eigen::AlignedBox2d map_box;
  Point frame_size;
  std::size_t columns = 1;

  std::size_t rows() const { return (frames.size() + columns - 1) / columns; }
  /// Of a frame: down the first column, then the next.
  Point corner(std::size_t k) const {
    const Point pitch(frame_size.x() + kMargin, frame_size.y() + kCaption);
    const std::size_t column = k / rows();
    const Point cell(static_cast<double>(column), static_cast<double>(k % rows()));
    return Point(kMargin, kMargin + kCaption) + cell.cwiseProduct(pitch);
  }
};

Paint FrameColor(const Film& film, std::size_t i) {
  const std::vector<int> numbers = StepNumbers(film.trajectory);
  return TimeColor(numbers[static_cast<std::size_t>(film.steps[i])] /
                   std::max(1.0, static_cast<double>(numbers.back())));
}

/// A number in a disc.
void DrawNumber(const Point& at, std::size_t number, const Paint& paint, Canvas* canvas) {
  // White on the dark half of the colours, black on the light one.
  const double luminance = 0.3 * paint.red + 0.6 * paint.green + 0.1 * paint.blue;
  canvas->Disc(at, 8.5, kWhite);
  canvas->Disc(at, 7.5, paint);
  canvas->Text(at, std::to_string(number),
               {.size = 9.5, .paint = luminance > 0.5 ? kBlack : kWhite, .bold = true});
}

std::string CaptionOf(const Film& film, std::size_t i) {
  const int step = film.steps[i];
  if (step == 0) return "start";
  const sim::Action action = film.trajectory.steps[static_cast<std::size_t>(step) - 1].action;
  std::string name(sim::ActionName(action));
  std::replace(name.begin(), name.end(), '_', ' ');
  const std::vector<int> numbers = StepNumbers(film.trajectory);
  const int number = numbers[static_cast<std::size_t>(step)];
  const bool is_step = number > numbers[static_cast<std::size_t>(step) - 1];
  return is_step ? fmt::format("step {}: {}", number, name)
                 : fmt::format("{} after step {}", name, number);
}

/// Names of directions over the first picture.
void DrawDirections(const Film& film, double y, Canvas* canvas) {
  constexpr std::array<std::pair<double, const char*>, 3> kDirections = {
      {{0.25, "left"}, {0.5, "ahead"}, {0.75, "right"}}};
  for (const auto& [share, text] : kDirections) {
    canvas->Text({kMargin + share * film.frame_size.x(), y}, text,
                 {.size = 9.5, .paint = kInk.WithAlpha(0.7)});
  }
}

/// What stands over a frame.
void DrawCaption(const Film& film, const Frame& frame, const Point& at, Canvas* canvas) {
  TextStyle style = {.size = kTextSize, .paint = kInk, .align = Align::kLeft};
  if (frame.is_goal) {
    style.bold = true;
    const bool is_one = film.trajectory.goals.size() == 1;
    canvas->Text(at, is_one ? "goal" : fmt::format("goal {}", frame.number + 1), style);
    return;
  }
  DrawNumber(at + Point(8.0, 0.0), frame.number + 1, FrameColor(film, frame.number), canvas);
  canvas->Text(at + Point(22.0, 0.0), CaptionOf(film, frame.number), style);
}

void DrawFrames(const Film& film, Canvas* canvas) {
  for (std::size_t k = 0; k < film.frames.size(); ++k) {
    const Point corner = film.corner(k);
    const sim::Image& image = film.frames[k].image;
    const double zoom = film.frame_size.x() / image.width;
    canvas->Picture(image, Eigen::Translation2d(corner) * Eigen::Scaling(zoom), true);
    const Point caption = corner - Point(0.0, 0.5 * kCaption);
    DrawCaption(film, film.frames[k], caption, canvas);
    if (k == 0) DrawDirections(film, caption.y(), canvas);
  }
}

/// Where a number may stand, best places first.
std::vector<Point> PlacesAround(const Point& at) {
  constexpr std::array kReaches = {15.5, 22.0, 30.0, 40.0};
  constexpr int kWays = 16;
  std::vector<Point> around;
  for (const double reach : kReaches) {
    for (int k = 0; k < kWays; ++k) {
      const double angle = 2.0 * sim::kPi * k / kWays - 0.25 * sim::kPi;
      around.push_back(at + reach * Point(sim::Cos(angle), sim::Sin(angle)));
    }
  }
  return around;
}

/// The numbers of the frames beside the path, clear of the marks and of each other.
void DrawNumbers(const Film& film, const MapPlace& place, Canvas* canvas) {
  const Point size = Point::Constant(18.0);
  FreePlaces places(place.box());
  places.Take(place.At(film.trajectory.start.position), size);
  for (const auto& goal : film.trajectory.goals) places.Take(place.At(goal.position), 1.2 * size);
  for (const GoalEnd& end : GoalEnds(film.trajectory)) {
    places.Take(place.At(end.pose.position), 0.8 * size);
  }
  const auto poses = TruePoses(film.trajectory);
  for (std::size_t i = 0; i < film.steps.size(); ++i) {
    const Point at = place.At(poses[static_cast<std::size_t>(film.steps[i])].position);
    const Point middle = places.Choose(PlacesAround(at), size);
    canvas->Line(at, middle, 3.0, kWhite);
    canvas->Line(at, middle, 1.4, FrameColor(film, i));
    DrawNumber(middle, i + 1, FrameColor(film, i), canvas);
  }
}

void DrawMap(const Film& film, Canvas* canvas) {
  const MapPlace place(film.map, film.map_box);
  DrawSceneMap(film.map, place, canvas);
  if (film.belief) DrawBelief(film.trajectory, place, canvas);
  DrawShortestPath(film.trajectory, place, canvas);
  DrawTruePath(film.trajectory, film.trajectory.steps.size(), place, canvas);
  if (film.belief) DrawBeliefMarks(film.map, film.trajectory, place, canvas);
  DrawNumbers(film, place, canvas);  // clear of marks, but the lines to them are not
  DrawMarks(film.trajectory, place, canvas);
}

void DrawOutcome(const Film& film, Canvas* canvas) {
  Point at(film.map_box.min().x(), film.map_box.max().y() + kLine);
  canvas->Text(at, film.title, {.size = 13.0, .paint = kInk, .bold = true, .align = Align::kLeft});
  for (const std::string& line : OutcomeLines(film.trajectory)) {
    at.y() += kLine;
    canvas->Text(at, line, {.size = kTextSize, .paint = kInk, .align = Align::kLeft});
  }
}

/// The views in order, each new goal before them.
std::vector<Frame> MakeFrames(const sim::World& world, const EpisodeTrajectory& trajectory,
                              const sim::PanoramaSpec& panorama, const std::vector<int>& steps,
                              std::vector<sim::Image> views) {
  std::vector<Frame> frames;
  std::optional<std::size_t> goal;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::size_t now = GoalAt(trajectory, static_cast<std::size_t>(steps[i]));
    if (now != goal) {
      frames.push_back(
          {true, now, LookFrom(world, trajectory.body, panorama, trajectory.goals[now])});
    }
    goal = now;
    frames.push_back({false, i, std::move(views[i])});
  }
  return frames;
}

}  // namespace

std::vector<int> FilmSteps(std::size_t steps, int frames) {
  const auto last = static_cast<int>(steps);
  const int gaps = std::max(1, std::min(frames - 1, last));
  std::vector<int> chosen;
  for (int i = 0; i <= gaps; ++i) {
    const int step = (i * last + gaps / 2) / gaps;
    if (chosen.empty() || step > chosen.back()) chosen.push_back(step);
  }
  return chosen;
}

std::size_t GoalAt(const EpisodeTrajectory& trajectory, std::size_t actions) {
  std::size_t done = 0;
  for (const GoalEnd& end : GoalEnds(trajectory)) {
    const bool is_last = end.actions == trajectory.steps.size() && actions == end.actions;
    done += end.actions <= actions && !is_last ? 1 : 0;
  }
  return std::min(done, trajectory.goals.size() - 1);
}

Figure Filmstrip(const std::shared_ptr<const sim::World>& world, const SceneMap& map,
                 const EpisodeTrajectory& trajectory, const FilmstripSpec& spec) {
  auto film = std::make_shared<Film>();
  film->map = map;
  film->trajectory = trajectory;
  film->title = spec.title.empty() ? trajectory.result.key.agent : spec.title;
  film->steps = FilmSteps(trajectory.steps.size(), spec.frames);
  film->belief = spec.belief;
  film->frames = MakeFrames(*world, trajectory, spec.panorama, film->steps,
                            ReplayPanoramas(world, trajectory, spec.panorama, film->steps));
  film->frame_size = {spec.frame_width, spec.frame_width * spec.panorama.rows / spec.panorama.cols};
  film->columns = static_cast<std::size_t>(std::max(1, spec.columns));
  const double text = kLine * (1.5 + static_cast<double>(OutcomeLines(trajectory).size()));
  const double bottom = film->corner(film->rows() - 1).y() + film->frame_size.y();
  const Point corner(film->corner(film->rows() * film->columns).x(), kMargin);
  const Point map_size =
      FittingSize(map, {spec.map_width, std::max(kLeastMapHeight, bottom - text - kMargin)});
  film->map_box = {corner, corner + map_size};
  Figure figure;
  figure.width = static_cast<int>(std::ceil(corner.x() + map_size.x() + kMargin));
  figure.height =
      static_cast<int>(std::ceil(std::max(bottom, kMargin + map_size.y() + text) + kMargin));
  figure.draw = [film](Canvas* canvas) {
    DrawFrames(*film, canvas);
    DrawMap(*film, canvas);
    DrawOutcome(*film, canvas);
  };
  return figure;
}

}  // namespace bulletnav::bench
