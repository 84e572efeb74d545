// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>

#include "agent/belief.h"
#include "agent/mapping/map_spec.h"
#include "agent/mapping/view_window.h"
#include "agent/models/free_space_model.h"
#include "agent/observation.h"
#include "sim/grid/grid.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// A point of the agent's plane: metres in the frame of its start pose, x ahead, y left.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

inline double Distance(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Obstacles, explored floor and the body's own track, on cells of the agent's plane.
/// A cell becomes an obstacle when points in the body's height are seen on it and free again when
/// only floor has been seen there a few times; where the body has been it is passable whatever was
/// seen later; walls that were only felt stay until forgotten. Unseen cells are kUnknown.
/// Source: Active Neural SLAM's mapper; the fading of obstacles and the moving map are ours.
class MetricMap {
 public:
  /// Maps by depth if the rig has it, else by what `mapper` makes of colour. Throws Error if it has
  /// neither, or no depth as far as the vision goes.
  MetricMap(const Rig& rig, const MapSpec& spec, std::shared_ptr<FreeSpaceModel> mapper = nullptr);
  /// Maps by another view, such as a simulated one, of the spec's cells and vision, for a body that
  /// begins at `pose`.
  MetricMap(const MapSpec& spec, std::unique_ptr<ViewWindow> view, const sim::PlanarPose& pose);

  /// Forgets everything; the body is at `pose`.
  void Clear(const sim::PlanarPose& pose);

  /// Adds the panorama taken at `pose`. Changes only cells within the vision, unless the
  /// body nears the edge: then the map moves, and what leaves it is forgotten.
  void Update(const Panorama& panorama, const sim::PlanarPose& pose);

  /// Marks the body's way between two poses as passable.
  void MarkTrack(const sim::PlanarPose& from, const sim::PlanarPose& to);

  /// Marks a felt wall, two cells thick and `width_cells` wide, 0.15 m ahead of `pose`.
  void MarkWall(const sim::PlanarPose& pose, int width_cells);
  /// The same where cells near a point are unknown that no view reaches, or no way.
  void MarkNoWay(const Point& p, double radius);
  /// Marks an edge that runs between two points, two cells thick, but for where the body has been.
  void MarkEdge(const Point& from, const Point& to);
  void ForgetFeltWalls();
  /// Those on explored cells within `radius` metres of a point.
  void ForgetFeltWalls(const Point& p, double radius);

  sim::Cell CellAt(const Point& p) const;
  Point Centre(const sim::Cell& cell) const;
  const MapSpec& spec() const { return spec_; }
  /// What planners see: obstacles grown by the dilation, the rim blocked.
  const sim::Grid<sim::CellState>& states() const { return states_; }
  bool IsObstacle(const sim::Cell& c) const { return evidence_[c] > 0; }
  bool IsExplored(const sim::Cell& c) const { return explored_[c] != 0; }
  bool IsTrack(const sim::Cell& c) const { return track_[c] != 0; }
  bool IsFeltWall(const sim::Cell& c) const { return felt_[c] != 0; }
  /// How much of what the map has in the last view's sight is contradicted by it: the share of its
  /// obstacles that were looked through, and how many cells these are. Obstacles that appear, fade
  /// or move make a few; a map that drift has turned, most.
  struct Contradiction {
    int through = 0;
    int all = 0;
    double share() const { return all == 0 ? 0.0 : static_cast<double>(through) / all; }
  };
  const Contradiction& contradiction() const { return contradiction_; }
  /// Cells seen since Clear.
  std::int64_t seen_cells() const { return seen_cells_; }
  MapPicture Picture() const;

 private:
  void Merge(const sim::Cell& middle);
  void Contradict(const sim::Cell& seen, const sim::Cell& cell);
  void MergeCell(const sim::Cell& seen, const sim::Cell& cell);
  void MoveTo(const sim::Cell& middle);
  void SetFelt(const Point& p, double radius, bool is_explored, bool is_felt);
  /// Derives states_ again around a cell.
  void Refresh(const sim::Cell& middle, int reach);
  sim::CellState OpenState(const sim::Cell& cell) const;
  /// Blocks or tightens the cells around an obstacle, inside a box.
  void GrowObstacle(const sim::Cell& obstacle, const sim::Cell& low, const sim::Cell& high);

  MapSpec spec_;
  std::unique_ptr<ViewWindow> view_;
  sim::Cell low_;  // the corner cell, in cells of the plane
  std::int64_t seen_cells_ = 0;
  Contradiction contradiction_;
  sim::Grid<std::uint8_t> evidence_;
  sim::Grid<std::uint8_t> explored_;
  sim::Grid<std::uint8_t> track_;
  sim::Grid<std::uint8_t> felt_;
  sim::Grid<sim::CellState> states_;
};

}  // namespace bulletnav::agent
