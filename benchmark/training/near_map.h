// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "agent/mapping/depth_ring.h"
#include "agent/mapping/fast_marching.h"
#include "agent/mapping/grid.h"
#include "agent/mapping/map_spec.h"
#include "agent/observation.h"

namespace bulletnav::bench {

/// The map that one panorama of depth gives of the 3 m around its camera, and the ways in it.
/// Cells of 5 cm in the frame of the body: it stands in the middle of the middle cell and looks
/// along x. Obstacles are points 0.25 to 1.5 m above the floor within 3 m, grown by the body's
/// radius; farther ones are ignored. A cell can be walked on if it was looked at or over and no
/// obstacle is near: what is hidden behind obstacles cannot, as nobody knows whether there is a
/// floor. The body's own place can always be walked on.
/// Source: Neural Topological SLAM, appendix B, inter-node labels; cells and heights of Active
/// Neural SLAM's mapper; the treatment of hidden cells is ours.
class NearMap {
 public:
  /// Throws sim::Error if the rig's depth ends within the map.
  NearMap(const agent::Rig& rig, double body_radius);

  /// Expects: depth of the rig's size (checked).
  void Project(std::span<const float> depth);

  /// Whether the shortest way to the point 3 m away in a direction is less than 1.05 * 3 m.
  bool IsExplorable(int direction) const;
  /// Length in metres of the shortest way to the point 3 m away; infinite if there is none.
  double WayTo(int direction) const;
  /// Metres to the farthest point of a direction, up to 3 m, that was seen and can be walked to; 0
  /// if there is none.
  double Reach(int direction) const;

  /// kFree or kBlocked.
  const agent::Grid<agent::CellState>& states() const { return states_; }
  const agent::Cell& middle() const { return middle_; }
  double cell() const { return spec_.cell; }

 private:
  agent::Cell CellAlong(int direction, double distance) const;
  void BlockAround(const agent::Cell& obstacle);
  void FreeMiddle();

  agent::MapSpec spec_;
  agent::DepthRing ring_;
  int body_;  // radius, in cells
  agent::Cell middle_;
  agent::Grid<agent::CellState> states_;
  agent::FastMarching march_;
};

}  // namespace bulletnav::bench
