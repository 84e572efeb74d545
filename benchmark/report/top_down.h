// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "benchmark/report/canvas.h"
#include "sim/navmesh/navmesh.h"
#include "sim/scene/mesh.h"

namespace bulletnav::bench {

struct TopDownSpec {
  int max_pixels = 1400;         // longer side of the picture
  float pixel_m = 0.01f;         // finest scale
  float cut_height_m = 1.9f;     // above the floor: what is higher, such as ceilings, is left out
  bool walkable = true;          // tint the walkable floor
  std::optional<float> floor_y;  // of the storey to show; else the largest island's
};

/// A name to print on the map, centred at a place in the world.
struct MapLabel {
  std::string text;
  Eigen::Vector2f at = Eigen::Vector2f::Zero();  // world x, z
  std::vector<Eigen::Vector2f> inside;  // rectilinear outline to stay in, printed smaller or left
                                        // out where it does not fit; empty: no limit
};

/// Where the world is in a map: pixel = (world - origin) / metres a pixel; x right, z down.
struct MapFrame {
  Eigen::Vector2f origin = Eigen::Vector2f::Zero();
  float pixel_m = 0.01f;
  Canvas::Point pixel(const Eigen::Vector3f& world) const;
  Canvas::Point pixel(const Eigen::Vector2f& world) const;
};

/// A scene as seen from above, from the cut at cut_height_m over the floor.
struct TopDownView {
  MapFrame frame;
  float floor_y = 0.0f;
  sim::Image colors;           // RGB, true; white where there is nothing below the cut
  std::vector<float> heights;  // [y, x] metres over the floor of what is seen; NaN: nothing
  std::vector<Eigen::Vector2f> sections;  // where surfaces are cut: two ends of a line each
};
TopDownView LookDown(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh,
                     const TopDownSpec& spec = {});

/// Whether a label printed in this size keeps a margin from its room's outline.
bool Fits(const MapLabel& label, const Canvas::Point& text_size, double pixel_m);

/// Length in metres of the bar that shows a map's scale, for a map this wide.
double ScaleBarLength(double width_m);

/// A scene from above in its true colours, cut open at cut_height_m over the largest island's
/// floor, walls in section drawn black, the walkable floor tinted, labels and a scale bar.
sim::Image DrawTopDown(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh,
                       const std::vector<MapLabel>& labels, const TopDownSpec& spec = {});

}  // namespace bulletnav::bench
