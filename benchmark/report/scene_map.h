// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "benchmark/report/canvas.h"
#include "benchmark/report/top_down.h"
#include "sim/house/floor_plan.h"

namespace bulletnav::bench {

/// A storey of a scene, made ready to draw trajectories on: made once, drawn often.
struct SceneMap {
  MapFrame frame;       // of the backdrop
  sim::Image backdrop;  // RGBA: furniture in muted colours, clear where there is floor or nothing
  std::vector<Eigen::Vector2f> walkable;  // triangles' corners
  std::vector<Eigen::Vector2f> sections;  // cut walls, two ends each; empty with a plan
  std::optional<sim::FloorPlan> plan;     // walls, doors, windows and room names to draw
};

/// The storey of the largest island, or the one at spec.floor_y. `plan`: of a generated house.
SceneMap MakeSceneMap(const sim::SceneMesh& mesh, const sim::Navmesh& navmesh,
                      std::optional<sim::FloorPlan> plan, const TopDownSpec& spec = {});

/// Where a scene's map lies on a canvas.
class MapPlace {
 public:
  /// As large as fits into the box, in its middle.
  MapPlace(const SceneMap& map, const Eigen::AlignedBox2d& box);

  /// World x, z to canvas.
  Canvas::Point At(double x, double z) const;
  Canvas::Point At(const Eigen::Vector3d& world) const { return At(world.x(), world.z()); }
  double pixels_per_metre() const { return pixels_per_metre_; }
  /// What the map covers of the canvas.
  const Eigen::AlignedBox2d& box() const { return box_; }

 private:
  Eigen::Vector2d origin_;  // world x, z of the box's upper left corner
  double pixels_per_metre_ = 1.0;
  Eigen::AlignedBox2d box_;
};

/// Size of a map that is at most so large, in the proportions of the scene.
Canvas::Point FittingSize(const SceneMap& map, const Canvas::Point& largest);

/// Where DrawSceneMap prints the rooms' names.
std::vector<Eigen::AlignedBox2d> RoomNameBoxes(const SceneMap& map, const MapPlace& place,
                                               const Canvas& canvas);

/// Floor, furniture, walls, room names and a scale bar.
void DrawSceneMap(const SceneMap& map, const MapPlace& place, Canvas* canvas);

}  // namespace bulletnav::bench
