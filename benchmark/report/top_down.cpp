// SPDX-License-Identifier: MIT
#include "benchmark/report/top_down.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "sim/render/embree/raycaster.h"
#include "sim/render/shade_point.h"

namespace bulletnav::bench {
namespace {

using Vec = Eigen::Vector3f;

constexpr Paint kWall = {0.1, 0.1, 0.12};
constexpr Paint kWalkable = {0.1, 0.75, 0.35, 0.25};
constexpr Paint kOtherIsland = {0.95, 0.6, 0.1, 0.3};
constexpr float kMargin = 0.5f;  // metres around the scene
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

/// Looks straight down from the cut at every pixel.
class Drawing {
 public:
  Drawing(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh, const TopDownSpec& spec)
      : mesh_(mesh), navmesh_(navmesh) {
    const Eigen::AlignedBox3f box = mesh.Bounds();
    const Eigen::Vector2f size(box.sizes().x() + 2 * kMargin, box.sizes().z() + 2 * kMargin);
    frame_.pixel_m = std::max(spec.pixel_m, size.maxCoeff() / static_cast<float>(spec.max_pixels));
    frame_.origin = {box.min().x() - kMargin, box.min().z() - kMargin};
    width_ = static_cast<int>(std::ceil(size.x() / frame_.pixel_m));
    height_ = static_cast<int>(std::ceil(size.y() / frame_.pixel_m));
    cut_ = FloorHeight(mesh, navmesh) + spec.cut_height_m;
  }

  sim::Image Colors() const {
    const sim::RenderMesh render_mesh(mesh_);
    const sim::Raycaster raycaster(render_mesh.corners);
    sim::Image image(width_, height_, 3);
    std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{255});
    const float pixel_m2 = frame_.pixel_m * frame_.pixel_m;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const Vec from(frame_.origin.x() + frame_.pixel_m * (static_cast<float>(x) + 0.5f), cut_,
                       frame_.origin.y() + frame_.pixel_m * (static_cast<float>(y) + 0.5f));
        const sim::RayHit hit = raycaster.Cast(from, -Vec::UnitY());
        if (hit.triangle < 0) continue;
        const auto triangle = static_cast<std::size_t>(hit.triangle);
        const sim::Rgb8 color =
            sim::ShadePoint(render_mesh, triangle, from - hit.t * Vec::UnitY(), pixel_m2);
        std::copy(color.begin(), color.end(), image.at(x, y));
      }
    }
    return image;
  }

  void Walkable(Canvas* canvas) const {
    std::vector<Canvas::Point> largest;
    std::vector<Canvas::Point> others;
    for (std::size_t t = 0; t < navmesh_.triangle_islands().size(); ++t) {
      auto& corners = navmesh_.triangle_islands()[t] == 0 ? largest : others;
      for (std::size_t k = 0; k < 3; ++k) {
        corners.push_back(frame_.pixel(navmesh_.triangle_corners()[3 * t + k]));
      }
    }
    canvas->FillTriangles(largest, kWalkable);
    canvas->FillTriangles(others, kOtherIsland);
  }

  /// Where the cut's plane meets triangles.
  void Sections(Canvas* canvas) const {
    for (const auto& t : mesh_.triangles) {
      std::vector<Vec> ends;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec& a = mesh_.positions[t[k]];
        const Vec& b = mesh_.positions[t[(k + 1) % 3]];
        if ((a.y() < cut_) == (b.y() < cut_)) continue;
        ends.push_back(a + (cut_ - a.y()) / (b.y() - a.y()) * (b - a));
      }
      if (ends.size() == 2) {
        canvas->Line(frame_.pixel(ends[0]), frame_.pixel(ends[1]), kWallLine, kWall);
      }
    }
  }

  void Label(const MapLabel& label, Canvas* canvas) const {
    for (int size = kLabelSize; size >= kSmallestLabel; --size) {
      if (!Fits(label, canvas->TextSize(label.text, size))) continue;
      canvas->Text(frame_.pixel(label.at), label.text, size, kWall);
      return;
    }
  }

  void ScaleBar(Canvas* canvas) const {
    const double metres = frame_.pixel_m * static_cast<float>(width_) > 30.0f ? 5.0 : 1.0;
    const Canvas::Point a(12.0, height_ - 12.0);
    const Canvas::Point b = a + Canvas::Point(metres / frame_.pixel_m, 0.0);
    canvas->Line(a, b, 3.0, kWall);
    canvas->Text(0.5 * (a + b) - Canvas::Point(0, 12), fmt::format("{} m", metres), 13.0, kWall);
  }

 private:
  bool Fits(const MapLabel& label, const Canvas::Point& text_size) const {
    const Eigen::Vector2f half =
        0.5f * frame_.pixel_m *
        (text_size + Canvas::Point::Constant(2.0 * kLabelMargin)).cast<float>();
    const Eigen::AlignedBox2f text(label.at - half, label.at + half);
    const std::size_t n = label.inside.size();
    for (std::size_t i = 0; i < n; ++i) {
      Eigen::AlignedBox2f side(label.inside[i]);
      side.extend(label.inside[(i + 1) % n]);
      if (side.intersects(text)) return false;
    }
    return true;
  }

  const sim::SceneMesh& mesh_;
  const sim::Navmesh& navmesh_;
  MapFrame frame_;
  int width_ = 0;
  int height_ = 0;
  float cut_ = 0.0f;
};

}  // namespace

Canvas::Point MapFrame::pixel(const Vec& world) const {
  return pixel(Eigen::Vector2f(world.x(), world.z()));
}

Canvas::Point MapFrame::pixel(const Eigen::Vector2f& world) const {
  return ((world - origin) / pixel_m).cast<double>();
}

sim::Image DrawTopDown(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh,
                       const std::vector<MapLabel>& labels, const TopDownSpec& spec) {
  const Drawing drawing(mesh, navmesh, spec);
  Canvas canvas(drawing.Colors());
  if (spec.walkable) drawing.Walkable(&canvas);
  drawing.Sections(&canvas);
  for (const MapLabel& label : labels) drawing.Label(label, &canvas);
  drawing.ScaleBar(&canvas);
  return canvas.ToImage();
}

}  // namespace bulletnav::bench
