// SPDX-License-Identifier: MIT
#include "benchmark/report/top_down.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/core.h>

#include "sim/render/cpu/ray_tracer.h"
#include "sim/render/shade_point.h"

namespace bulletnav::bench {
namespace {

using Vec = Eigen::Vector3f;

constexpr Paint kWall = {0.1, 0.1, 0.12};
constexpr Paint kWalkable = {0.1, 0.75, 0.35, 0.25};
constexpr Paint kOtherIsland = {0.95, 0.6, 0.1, 0.3};
constexpr float kMargin = 0.5f;           // metres around the scene
constexpr float kScaleBarShare = 0.03f;   // of the longer side, at least free below it
constexpr float kFloorThickness = 0.08f;  // metres
constexpr double kWallLine = 2.0;
constexpr int kLabelSize = 15;  // pixels
constexpr int kSmallestLabel = 10;
constexpr double kLabelMargin = 3.0;  // pixels

/// Median height of the largest island; the lowest point of the mesh if nothing is walkable.
float FloorHeight(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh) {
  std::vector<float> heights;
  for (std::size_t t = 0; t < navmesh.triangle_islands().size(); ++t) {
    if (navmesh.triangle_islands()[t] == 0) {
      heights.push_back(navmesh.triangle_corners()[3 * t].y());
    }
  }
  if (heights.empty()) return mesh.Bounds().min().y();
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return *middle;
}

/// Corners on the map of the triangles of the largest island, or of all others.
std::vector<Canvas::Point> IslandCorners(const sim::Navmesh& navmesh, const MapFrame& frame,
                                         bool largest) {
  std::vector<Canvas::Point> corners;
  for (std::size_t t = 0; t < navmesh.triangle_islands().size(); ++t) {
    if ((navmesh.triangle_islands()[t] == 0) != largest) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      corners.push_back(frame.pixel(navmesh.triangle_corners()[3 * t + k]));
    }
  }
  return corners;
}

/// White where one can walk.
sim::Image WalkableMask(const sim::Navmesh& navmesh, const TopDownView& view) {
  Canvas canvas(view.colors.width, view.colors.height, {});
  for (const bool largest : {true, false}) {
    canvas.FillTriangles(IslandCorners(navmesh, view.frame, largest), {1.0, 1.0, 1.0});
  }
  return canvas.ToImage();
}

/// Looks at a scene from points of the cut's plane.
class TopView {
 public:
  explicit TopView(const sim::SceneMesh& mesh) : mesh_(mesh), raycaster_(mesh_.corners) {}

  struct Sight {
    Vec at;
    std::int32_t triangle;
  };

  /// What is seen straight below.
  std::optional<Sight> Below(const Vec& from) const {
    const sim::RayHit hit = raycaster_.Cast(from, -Vec::UnitY());
    if (hit.triangle < 0) return std::nullopt;
    return Sight{from - hit.t * Vec::UnitY(), hit.triangle};
  }

  /// The nearest surface seen from its back, if the point is inside something: a wardrobe without
  /// its top, which nobody sees, is nothing but sides.
  std::optional<Sight> Inside(const Vec& from) const {
    std::optional<Sight> nearest;
    float distance = std::numeric_limits<float>::infinity();
    int backs = 0;
    for (const Vec& direction : {Vec(1, 0, 0), Vec(-1, 0, 0), Vec(0, 0, 1), Vec(0, 0, -1)}) {
      const sim::RayHit hit = raycaster_.Cast(from, direction);
      if (hit.triangle < 0) return std::nullopt;  // out of doors, where walls show their backs too
      if (Normal(hit.triangle).dot(direction) <= 0.0f) continue;
      ++backs;
      if (hit.t >= distance) continue;
      distance = hit.t;
      nearest = {from + hit.t * direction, hit.triangle};
    }
    return backs >= 2 ? nearest : std::nullopt;  // two stand against walls in a corner
  }

  sim::Rgb8 Color(const Sight& sight, float pixel_m) const {
    return sim::ShadePoint(mesh_, static_cast<std::size_t>(sight.triangle), sight.at,
                           pixel_m * pixel_m);
  }

 private:
  Vec Normal(std::int32_t triangle) const {
    const auto& [a, b, c] = mesh_.corners[static_cast<std::size_t>(triangle)];
    return (b - a).cross(c - a);
  }

  sim::RenderMesh mesh_;
  sim::RayTracer raycaster_;
};

void Look(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh, float cut, TopDownView* view) {
  const TopView looker(mesh);
  const sim::Image walkable = WalkableMask(navmesh, *view);
  const float pixel_m = view->frame.pixel_m;
  const auto see = [&](const Vec& from, bool is_walkable) {
    auto below = looker.Below(from);
    const bool is_floor = !below || below->at.y() < view->floor_y + kFloorThickness;
    if (is_walkable || !is_floor) return below;
    auto inside = looker.Inside(from);
    return inside ? inside : below;
  };
  for (int y = 0; y < view->colors.height; ++y) {
    for (int x = 0; x < view->colors.width; ++x) {
      const Vec from(view->frame.origin.x() + pixel_m * (static_cast<float>(x) + 0.5f), cut,
                     view->frame.origin.y() + pixel_m * (static_cast<float>(y) + 0.5f));
      const auto sight = see(from, walkable.at(x, y)[0] > 0);
      view->heights.push_back(sight ? sight->at.y() - view->floor_y
                                    : std::numeric_limits<float>::quiet_NaN());
      if (!sight) continue;
      const sim::Rgb8 color = looker.Color(*sight, pixel_m);
      std::copy(color.begin(), color.end(), view->colors.at(x, y));
    }
  }
}

/// Where the cut's plane meets triangles.
std::vector<Eigen::Vector2f> Sections(const sim::SceneMesh& mesh, float cut) {
  std::vector<Eigen::Vector2f> sections;
  for (const auto& t : mesh.triangles) {
    std::vector<Eigen::Vector2f> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec& a = mesh.positions[t[k]];
      const Vec& b = mesh.positions[t[(k + 1) % 3]];
      if ((a.y() < cut) == (b.y() < cut)) continue;
      const Vec p = a + (cut - a.y()) / (b.y() - a.y()) * (b - a);
      ends.emplace_back(p.x(), p.z());
    }
    if (ends.size() == 2) sections.insert(sections.end(), ends.begin(), ends.end());
  }
  return sections;
}

void DrawLabel(const MapLabel& label, const MapFrame& frame, Canvas* canvas) {
  for (int size = kLabelSize; size >= kSmallestLabel; --size) {
    if (!Fits(label, canvas->TextSize(label.text, size), frame.pixel_m)) continue;
    canvas->Text(frame.pixel(label.at), label.text, size, kWall);
    return;
  }
}

void DrawScaleBar(const TopDownView& view, Canvas* canvas) {
  const double pixel_m = view.frame.pixel_m;
  const double metres = ScaleBarLength(pixel_m * view.colors.width);
  const Canvas::Point a(12.0, view.colors.height - 12.0);
  const Canvas::Point b = a + Canvas::Point(metres / pixel_m, 0.0);
  canvas->Line(a, b, 3.0, kWall);
  canvas->Text(b + Canvas::Point(8.0, 0.0), fmt::format("{} m", metres),
               {.size = 13.0, .paint = kWall, .bold = true, .align = Align::kLeft, .halo = true});
}

}  // namespace

Canvas::Point MapFrame::pixel(const Vec& world) const {
  return pixel(Eigen::Vector2f(world.x(), world.z()));
}

Canvas::Point MapFrame::pixel(const Eigen::Vector2f& world) const {
  return ((world - origin) / pixel_m).cast<double>();
}

TopDownView LookDown(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh,
                     const TopDownSpec& spec) {
  TopDownView view;
  const Eigen::AlignedBox3f box = mesh.Bounds();
  const float below =
      std::max(kMargin, kScaleBarShare * std::max(box.sizes().x(), box.sizes().z()));
  const Eigen::Vector2f size(box.sizes().x() + 2 * kMargin, box.sizes().z() + kMargin + below);
  view.frame.pixel_m =
      std::max(spec.pixel_m, size.maxCoeff() / static_cast<float>(spec.max_pixels));
  view.frame.origin = {box.min().x() - kMargin, box.min().z() - kMargin};
  view.floor_y = spec.floor_y.value_or(FloorHeight(mesh, navmesh));
  view.colors = sim::Image(static_cast<int>(std::ceil(size.x() / view.frame.pixel_m)),
                           static_cast<int>(std::ceil(size.y() / view.frame.pixel_m)), 3);
  std::fill(view.colors.pixels.begin(), view.colors.pixels.end(), std::uint8_t{255});
  const float cut = view.floor_y + spec.cut_height_m;
  Look(mesh, navmesh, cut, &view);
  view.sections = Sections(mesh, cut);
  return view;
}

bool Fits(const MapLabel& label, const Canvas::Point& text_size, double pixel_m) {
  const Eigen::Vector2f half =
      (0.5 * pixel_m * (text_size + Canvas::Point::Constant(2.0 * kLabelMargin))).cast<float>();
  const Eigen::AlignedBox2f text(label.at - half, label.at + half);
  const std::size_t n = label.inside.size();
  for (std::size_t i = 0; i < n; ++i) {
    Eigen::AlignedBox2f side(label.inside[i]);
    side.extend(label.inside[(i + 1) % n]);
    if (side.intersects(text)) return false;
  }
  return true;
}

double ScaleBarLength(double width_m) {
  return width_m > 30.0 ? 5.0 : 1.0;
}

sim::Image DrawTopDown(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh,
                       const std::vector<MapLabel>& labels, const TopDownSpec& spec) {
  const TopDownView view = LookDown(mesh, navmesh, spec);
  Canvas canvas(view.colors);
  if (spec.walkable) {
    canvas.FillTriangles(IslandCorners(navmesh, view.frame, true), kWalkable);
    canvas.FillTriangles(IslandCorners(navmesh, view.frame, false), kOtherIsland);
  }
  for (std::size_t i = 0; i + 1 < view.sections.size(); i += 2) {
    canvas.Line(view.frame.pixel(view.sections[i]), view.frame.pixel(view.sections[i + 1]),
                kWallLine, kWall);
  }
  for (const MapLabel& label : labels) DrawLabel(label, view.frame, &canvas);
  DrawScaleBar(view, &canvas);
  return canvas.ToImage();
}

}  // namespace bulletnav::bench
