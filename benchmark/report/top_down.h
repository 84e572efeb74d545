// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "benchmark/report/canvas.h"
#include "sim/navmesh/navmesh.h"
#include "sim/scene/mesh.h"

namespace bulletnav::bench {

struct TopDownSpec {
  int max_pixels = 1400;      // longer side of the picture
  float pixel_m = 0.01f;      // finest scale
  float cut_height_m = 1.9f;  // above the floor: what is higher, such as ceilings, is left out
  bool walkable = true;       // tint the walkable floor
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

/// A scene from above in its true colours, cut open at cut_height_m over the largest island's
/// floor, walls in section drawn black, the walkable floor tinted, labels and a scale bar.
sim::Image DrawTopDown(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh,
                       const std::vector<MapLabel>& labels, const TopDownSpec& spec = {});

}  // namespace bulletnav::bench
