// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "agent/mapping/depth_ring.h"
#include "agent/mapping/map_spec.h"
#include "benchmark/training/supervised/data_config.h"
#include "sim/grid/fast_marching.h"
#include "sim/grid/grid.h"

namespace bulletnav::bench {

/// The map that one panorama of depth gives of the 3 m around its camera, and the ways in it.
/// Cells of 5 cm in the frame of the body: it stands in the middle of the middle cell and looks
/// along x. Obstacles are points 0.25 to 1.5 m above the floor within 3 m, grown by the body's
/// radius; farther ones are ignored, as are those on the body's own place. Cells that were looked
/// at or over are free, others hidden. Ways to the points 3 m away may lead through hidden cells
/// if config.hidden says so, but not to points more than 0.5 m from floor that was seen and can be
/// walked to: what lies deep behind a wardrobe is a wall. The farthest points were seen, and ways
/// to them lead over seen cells. Source: Neural Topological SLAM, appendix B, inter-node labels;
/// cells and heights of Active Neural SLAM's mapper.
class NearMap {
 public:
  explicit NearMap(const DataConfig& config);

  /// Expects: depth of the config's panorama (checked).
  void Project(std::span<const float> depth);

  /// Whether the shortest way to the point 3 m away in a direction is less than 1.05 * 3 m.
  bool IsExplorable(int direction) const;
  /// Metres of the shortest way to the point 3 m away, or within config.target_slack of it and
  /// from there as the crow flies; infinite if there is none. Up to 3% too long, but near 1.05 * 3
  /// m ways with at most one bend are exact.
  double WayTo(int direction) const;
  /// Metres to the farthest point of a direction, up to 3 m, that was seen and can be walked to; 0
  /// if there is none.
  double Reach(int direction) const;

  /// Hidden cells are kUnknown where ways may lead through them, else kBlocked.
  const sim::Grid<sim::CellState>& states() const { return states_; }
  const sim::Cell& middle() const { return middle_; }
  double cell() const { return spec_.cell; }

 private:
  sim::Cell CellAlong(int direction, double distance) const;
  bool IsNearSeenFloor(const sim::Cell& cell) const;
  double CellsTo(const sim::Cell& cell) const;
  double WithOneBend(const sim::Cell& cell, double longest) const;
  void BlockAround(const sim::Cell& obstacle);
  void FreeMiddle();

  agent::MapSpec spec_;
  agent::DepthRing ring_;
  int body_;  // radius, in cells
  int slack_;
  sim::CellState hidden_;
  sim::Cell middle_;
  sim::Grid<sim::CellState> states_;
  sim::FastMarching seen_ways_;
  sim::FastMarching ways_;
};

}  // namespace bulletnav::bench
