// SPDX-License-Identifier: MIT
#include "benchmark/slam/plots/drive_figure.h"

#include <algorithm>
#include <cstddef>
#include <memory>

#include <fmt/core.h>

#include "benchmark/report/palette.h"
#include "benchmark/report/top_down.h"
#include "benchmark/slam/runs/measure_drive.h"

namespace bulletnav::bench {
namespace {

constexpr double kPanel = 420.0;  // units of a panel's width, and of its height at most
constexpr double kLegend = 34.0;
constexpr double kTitle = 34.0;
constexpr double kGap = 16.0;
constexpr std::size_t kInARow = 3;  // panels

using Way = std::vector<Eigen::Vector2d>;  // world x, z

/// The estimate in the world: its first pose is the first true one.
Way WayOf(const std::vector<sim::PlanarPose>& poses, const sim::BodyPose& first) {
  Way way;
  way.reserve(poses.size());
  for (const sim::PlanarPose& pose : poses) {
    const Eigen::Vector3d at = sim::Apply(first, pose).position;
    way.emplace_back(at.x(), at.z());
  }
  return way;
}

Way WayOf(const std::vector<sim::BodyPose>& poses) {
  Way way;
  way.reserve(poses.size());
  for (const sim::BodyPose& pose : poses) way.emplace_back(pose.position.x(), pose.position.z());
  return way;
}

std::string CountText(const std::vector<LoopRecord>& loops) {
  const auto count = std::count_if(loops.begin(), loops.end(), [](const LoopRecord& loop) {
    return loop.is_accepted;
  });
  return count == 1 ? "1 loop" : fmt::format("{} loops", count);
}

/// With how far it is off, laid on the first true pose, in the mean.
std::string TitleOf(const DrivePanel& panel, bool is_odometry,
                    const std::vector<sim::BodyPose>& truth) {
  if (truth.empty() || truth.size() != panel.poses.size()) return panel.title;
  const double off = MeasureBoth(truth, panel.poses).start.mean;
  if (is_odometry) return fmt::format("{}: {:.2f} m off", panel.title, off);
  return fmt::format("{}: {}, {:.2f} m off", panel.title, CountText(panel.loops), off);
}

/// What is drawn, ready in the world's coordinates.
struct Drawing {
  std::vector<DrivePanel> panels;
  std::vector<Way> ways;
  Way truth;
  std::optional<SceneMap> map;
  Eigen::AlignedBox2d extent;

  double panel_height() const {
    return std::min(kPanel, kPanel * extent.sizes().y() / extent.sizes().x());
  }
  std::size_t rows() const { return (panels.size() + kInARow - 1) / kInARow; }
  double height() const {
    return static_cast<double>(rows()) * (kTitle + panel_height() + kGap) + kLegend;
  }
};

Drawing DrawingOf(const DrivePicture& picture, const std::optional<SceneMap>& map) {
  Drawing drawing;
  drawing.panels = picture.panels;
  drawing.truth = WayOf(picture.truth);
  drawing.map = map;
  const sim::BodyPose first = picture.truth.empty() ? sim::BodyPose{} : picture.truth.front();
  for (const Eigen::Vector2d& at : drawing.truth) drawing.extent.extend(at);
  for (DrivePanel& panel : drawing.panels) {
    panel.title = TitleOf(panel, drawing.ways.empty(), picture.truth);
    drawing.ways.push_back(WayOf(panel.poses, first));
    for (const Eigen::Vector2d& at : drawing.ways.back()) drawing.extent.extend(at);
  }
  if (drawing.extent.isEmpty()) drawing.extent.extend(Eigen::Vector2d::Zero());
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(0.5);
  drawing.extent.extend(Eigen::Vector2d(drawing.extent.min() - margin));
  drawing.extent.extend(Eigen::Vector2d(drawing.extent.max() + margin));
  return drawing;
}

/// World to canvas within a panel.
class PanelPlace {
 public:
  PanelPlace(const Drawing& drawing, const Eigen::AlignedBox2d& box) {
    const Eigen::Vector2d size = drawing.extent.sizes();
    scale_ = std::min(box.sizes().x() / size.x(), box.sizes().y() / size.y());
    offset_ = box.center() - scale_ * drawing.extent.center();
  }
  Canvas::Point At(const Eigen::Vector2d& world) const { return scale_ * world + offset_; }
  double scale() const { return scale_; }

 private:
  double scale_ = 1.0;
  Eigen::Vector2d offset_;
};

std::vector<Canvas::Point> Placed(const Way& way, const PanelPlace& place) {
  std::vector<Canvas::Point> points;
  points.reserve(way.size());
  for (const Eigen::Vector2d& at : way) points.push_back(place.At(at));
  return points;
}

void DrawFloor(const SceneMap& map, const PanelPlace& place, Canvas* canvas) {
  std::vector<Canvas::Point> corners;
  corners.reserve(map.walkable.size());
  for (const Eigen::Vector2f& corner : map.walkable) {
    corners.push_back(place.At(corner.cast<double>()));
  }
  canvas->FillTriangles(corners, kInk.WithAlpha(0.08));
}

void DrawLoops(const std::vector<LoopRecord>& loops, const Way& way, const PanelPlace& place,
               Canvas* canvas) {
  for (const LoopRecord& loop : loops) {
    const auto last = std::max(loop.later, loop.earlier);
    if (!loop.is_accepted || last >= static_cast<int>(way.size())) continue;
    const Paint& paint = loop.is_wrong ? kVermillion : kGreen;
    canvas->Line(place.At(way[static_cast<std::size_t>(loop.earlier)]),
                 place.At(way[static_cast<std::size_t>(loop.later)]), 2.0, paint.WithAlpha(0.9));
  }
}

/// Where a panel's ways are drawn, below its title.
Eigen::AlignedBox2d BoxOf(const Drawing& drawing, std::size_t panel) {
  const double left = kGap + static_cast<double>(panel % kInARow) * (kPanel + kGap);
  const std::size_t row = panel / kInARow;
  const double top = static_cast<double>(row) * (kTitle + drawing.panel_height() + kGap) + kTitle;
  return {Eigen::Vector2d(left, top), Eigen::Vector2d(left + kPanel, top + drawing.panel_height())};
}

void DrawPanel(const Drawing& drawing, std::size_t panel, Canvas* canvas) {
  const Eigen::AlignedBox2d box = BoxOf(drawing, panel);
  const PanelPlace place(drawing, box);
  canvas->Clip(box);
  if (drawing.map) DrawFloor(*drawing.map, place, canvas);
  canvas->Polyline(Placed(drawing.truth, place), {2.5, kInk.WithAlpha(0.35), {}});
  const Way& way = drawing.ways[panel];
  const Paint& color = panel == 0 ? kOrange : kBlue;
  canvas->Polyline(Placed(way, place), {1.5, color, {}});
  DrawLoops(drawing.panels[panel].loops, way, place, canvas);
  if (!way.empty()) canvas->Disc(place.At(way.front()), 4.0, kInk);
  canvas->Unclip();
  canvas->Text({box.center().x(), box.min().y() - kTitle / 2.0}, drawing.panels[panel].title,
               {14.0, kInk, true, Align::kCenter, false, false});
}

constexpr double kSample = 26.0;  // of a line in the legend

/// A line with what it means; returns where the next one begins.
double DrawSample(const Canvas::Point& at, const Stroke& stroke, const std::string& text,
                  Canvas* canvas) {
  const std::vector<Canvas::Point> line = {at, at + Canvas::Point(kSample, 0.0)};
  canvas->Polyline(line, stroke);
  canvas->Text(at + Canvas::Point(kSample + 6.0, 0.0), text,
               {.size = 12.0, .paint = kInk, .align = Align::kLeft});
  constexpr double kLetter = 6.6;
  return at.x() + kSample + 24.0 + kLetter * static_cast<double>(text.size());
}

void DrawLegend(const Drawing& drawing, Canvas* canvas) {
  const double y = drawing.height() - kLegend / 2.0;
  const PanelPlace place(drawing, BoxOf(drawing, 0));
  const double metres = ScaleBarLength(drawing.extent.sizes().x());
  double x = kGap;
  const Canvas::Point end(x + place.scale() * metres, y);
  for (const Canvas::Point& tick : {Canvas::Point(x, y), end}) {
    canvas->Line(tick - Canvas::Point(0.0, 4.0), tick + Canvas::Point(0.0, 4.0), 1.5, kInk);
  }
  canvas->Line({x, y}, end, 1.5, kInk);
  canvas->Text(end + Canvas::Point(8.0, 0.0), fmt::format("{:g} m", metres),
               {.size = 12.0, .paint = kInk, .align = Align::kLeft});
  x = end.x() + 60.0;
  if (!drawing.truth.empty()) {
    x = DrawSample({x, y}, {2.5, kInk.WithAlpha(0.35), {}}, "true way", canvas);
  }
  x = DrawSample({x, y}, {1.5, kOrange, {}}, "odometry", canvas);
  if (drawing.panels.size() < 2) return;
  x = DrawSample({x, y}, {1.5, kBlue, {}}, "with loops", canvas);
  x = DrawSample({x, y}, {1.5, kGreen, {}}, "loop", canvas);
  if (!drawing.truth.empty()) DrawSample({x, y}, {2.0, kVermillion, {}}, "wrong loop", canvas);
}

}  // namespace

Figure DriveFigure(const DrivePicture& picture, const std::optional<SceneMap>& map) {
  const auto drawing = std::make_shared<const Drawing>(DrawingOf(picture, map));
  const std::size_t panels = picture.panels.size();
  const auto columns = static_cast<double>(std::min(panels, kInARow));
  Figure figure;
  figure.width = static_cast<int>(kGap + columns * (kPanel + kGap));
  figure.height = static_cast<int>(drawing->height());
  figure.draw = [drawing](Canvas* canvas) {
    for (std::size_t i = 0; i < drawing->panels.size(); ++i) DrawPanel(*drawing, i, canvas);
    if (!drawing->panels.empty()) DrawLegend(*drawing, canvas);
  };
  return figure;
}

}  // namespace bulletnav::bench
