// SPDX-License-Identifier: MIT
#include "benchmark/report/scene_map.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "benchmark/report/palette.h"
#include "benchmark/report/room_labels.h"

namespace bulletnav::bench {
namespace {

using Vec2 = Eigen::Vector2f;
using Point = Canvas::Point;

constexpr float kFloorThickness = 0.08f;  // what rises less, such as rugs, counts as floor
constexpr float kMostClimb = 1.0f;        // walkable floor farther off is of another storey
constexpr float kGrey = 205.0f;           // what furniture is blended with
constexpr float kColorShare = 0.3f;
constexpr Paint kRoom = {0.955, 0.955, 0.95};
constexpr Paint kWalkable = {0.87, 0.915, 0.945};
constexpr Paint kWall = {0.27, 0.27, 0.29};
constexpr Paint kWindow = {0.72, 0.80, 0.86};
constexpr Paint kDoorLeaf = {0.62, 0.55, 0.47};
constexpr Paint kLabel = {0.42, 0.42, 0.45};
constexpr double kLabelSize = 11.0;
constexpr double kSmallestLabel = 7.0;

std::uint8_t Muted(std::uint8_t value) {
  return static_cast<std::uint8_t>(kColorShare * static_cast<float>(value) +
                                   (1.0f - kColorShare) * kGrey);
}

sim::Image Backdrop(const TopDownView& view) {
  sim::Image image(view.colors.width, view.colors.height, 4);
  for (std::size_t i = 0; i < view.heights.size(); ++i) {
    if (!(view.heights[i] > kFloorThickness)) continue;  // floor, or nothing
    const std::uint8_t* color = &view.colors.pixels[3 * i];
    std::transform(color, color + 3, &image.pixels[4 * i], Muted);
    image.pixels[4 * i + 3] = 255;
  }
  return image;
}

std::vector<Vec2> Walkable(const sim::Navmesh& navmesh, float floor_y) {
  std::vector<Vec2> corners;
  for (std::size_t t = 0; t < navmesh.triangle_islands().size(); ++t) {
    const Eigen::Vector3f* triangle = &navmesh.triangle_corners()[3 * t];
    if (std::abs(triangle[0].y() - floor_y) > kMostClimb) continue;
    for (int k = 0; k < 3; ++k) corners.emplace_back(triangle[k].x(), triangle[k].z());
  }
  return corners;
}

/// A room's name as it is printed.
struct RoomName {
  std::string text;
  Point at;
  double size = kLabelSize;
  Point extent;
};

/// Those that fit into their rooms.
std::vector<RoomName> NamesOf(const sim::FloorPlan& plan, const MapPlace& place,
                              const Canvas& canvas) {
  std::vector<RoomName> names;
  for (const MapLabel& label : RoomLabels(plan)) {
    RoomName name = {label.text, place.At(label.at.x(), label.at.y()), kLabelSize, {}};
    for (; name.size >= kSmallestLabel; name.size -= 0.5) {
      name.extent = canvas.TextSize(label.text, name.size, false);
      if (!Fits(label, name.extent, 1.0 / place.pixels_per_metre())) continue;
      names.push_back(name);
      break;
    }
  }
  return names;
}

/// Draws the parts of a floor plan.
class PlanDrawing {
 public:
  PlanDrawing(const sim::FloorPlan& plan, const MapPlace& place, Canvas* canvas)
      : plan_(plan), place_(place), canvas_(canvas) {}

  void Rooms() const {
    for (const sim::Room& room : plan_.rooms) Fill(room.outline, kRoom);
  }

  void Walls() const {
    for (const sim::Wall& wall : plan_.walls) Wall(wall);
    for (const sim::Opening& opening : plan_.openings) {
      if (opening.has_leaf) Fill(sim::LeafOutline(opening), kDoorLeaf);
    }
  }

  void Labels() const {
    for (const RoomName& name : NamesOf(plan_, place_, *canvas_)) {
      canvas_->Text(name.at, name.text, {.size = name.size, .paint = kLabel, .halo = true});
    }
  }

 private:
  void Fill(std::span<const Vec2> outline, const Paint& paint) const {
    std::vector<Point> points;
    for (const Vec2& p : outline) points.push_back(place_.At(p.x(), p.y()));
    canvas_->Fill(points, paint);
  }

  /// A part of a wall, from and to in metres along its middle line.
  void Piece(const sim::Wall& wall, float from, float to, const Paint& paint) const {
    const Vec2 along = (wall.b - wall.a).normalized();
    const Vec2 aside = 0.5f * wall.thickness * sim::LeftOf(along);
    const Vec2 a = wall.a + from * along;
    const Vec2 b = wall.a + to * along;
    Fill(std::vector<Vec2>{a - aside, a + aside, b + aside, b - aside}, paint);
  }

  void Wall(const sim::Wall& wall) const {
    struct Gap {
      float from;
      float to;
      bool is_window;
    };
    const Vec2 along = (wall.b - wall.a).normalized();
    const float length = (wall.b - wall.a).norm();
    std::vector<Gap> gaps;
    for (const sim::Opening& opening : plan_.openings) {
      const Vec2 middle = 0.5f * (opening.a + opening.b) - wall.a;
      const float at = middle.dot(along);
      const bool is_in_wall = std::abs(middle.dot(sim::LeftOf(along))) < 0.5f * wall.thickness &&
                              at > 0.0f && at < length &&
                              std::abs((opening.b - opening.a).dot(along)) > 0.5f * opening.width();
      if (!is_in_wall) continue;
      gaps.push_back(
          {at - 0.5f * opening.width(), at + 0.5f * opening.width(), !opening.IsPassage()});
    }
    std::sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
      return a.from < b.from;
    });
    float done = -0.5f * wall.thickness;  // the ends close the corners
    for (const Gap& gap : gaps) {
      Piece(wall, done, gap.from, kWall);
      if (gap.is_window) Piece(wall, gap.from, gap.to, kWindow);
      done = gap.to;
    }
    Piece(wall, done, length + 0.5f * wall.thickness, kWall);
  }

  const sim::FloorPlan& plan_;
  const MapPlace& place_;
  Canvas* canvas_;
};

void DrawScaleBar(const MapPlace& place, Canvas* canvas) {
  const double metres = ScaleBarLength(place.box().sizes().x() / place.pixels_per_metre());
  const Point a(place.box().min().x() + 8.0, place.box().max().y() - 6.0);
  const Point b = a + Point(metres * place.pixels_per_metre(), 0.0);
  canvas->Line(a, b, 2.0, kInk);
  canvas->Text(b + Point(6.0, 0.0), fmt::format("{} m", metres),
               {.size = 10.0, .paint = kInk, .align = Align::kLeft});
}

}  // namespace

SceneMap MakeSceneMap(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh,
                      std::optional<sim::FloorPlan> plan, const TopDownSpec& spec) {
  TopDownView view = LookDown(mesh, navmesh, spec);
  SceneMap map;
  map.frame = view.frame;
  map.backdrop = Backdrop(view);
  map.walkable = Walkable(navmesh, view.floor_y);
  if (!plan) map.sections = std::move(view.sections);
  map.plan = std::move(plan);
  return map;
}

Canvas::Point FittingSize(const SceneMap& map, const Point& largest) {
  const Point size(map.backdrop.width, map.backdrop.height);
  return size * largest.cwiseQuotient(size).minCoeff();
}

MapPlace::MapPlace(const SceneMap& map, const Eigen::AlignedBox2d& box)
    : origin_(map.frame.origin.cast<double>()) {
  const Point size = FittingSize(map, box.sizes());
  pixels_per_metre_ = size.x() / (map.backdrop.width * double{map.frame.pixel_m});
  const Point corner = box.center() - 0.5 * size;
  box_ = {corner, corner + size};
}

Canvas::Point MapPlace::At(double x, double z) const {
  return box_.min() + pixels_per_metre_ * (Point(x, z) - origin_);
}

std::vector<Eigen::AlignedBox2d> RoomNameBoxes(const SceneMap& map, const MapPlace& place,
                                               const Canvas& canvas) {
  std::vector<Eigen::AlignedBox2d> boxes;
  if (!map.plan) return boxes;
  for (const RoomName& name : NamesOf(*map.plan, place, canvas)) {
    boxes.emplace_back(name.at - 0.5 * name.extent, name.at + 0.5 * name.extent);
  }
  return boxes;
}

void DrawSceneMap(const SceneMap& map, const MapPlace& place, Canvas* canvas) {
  std::vector<Point> walkable;
  for (const Vec2& p : map.walkable) walkable.push_back(place.At(p.x(), p.y()));
  std::optional<PlanDrawing> plan;
  if (map.plan) plan.emplace(*map.plan, place, canvas);
  if (plan) plan->Rooms();
  canvas->FillTriangles(walkable, kWalkable);
  const double zoom = place.pixels_per_metre() * double{map.frame.pixel_m};
  canvas->Picture(map.backdrop, Eigen::Translation2d(place.box().min()) * Eigen::Scaling(zoom),
                  true);
  for (std::size_t i = 0; i + 1 < map.sections.size(); i += 2) {
    const Vec2& a = map.sections[i];
    const Vec2& b = map.sections[i + 1];
    canvas->Line(place.At(a.x(), a.y()), place.At(b.x(), b.y()), 1.2, kWall);
  }
  if (plan) plan->Walls();
  if (plan) plan->Labels();
  DrawScaleBar(place, canvas);
}

}  // namespace bulletnav::bench
