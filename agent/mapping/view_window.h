// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "agent/observation.h"
#include "sim/grid/grid.h"

namespace bulletnav::agent {

/// What one panorama tells about the cells of a square window around the body: the body stands in
/// its middle cell; x and y as in the map.
class ViewWindow {
 public:
  virtual ~ViewWindow() = default;
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;
  ViewWindow(ViewWindow&&) = default;
  ViewWindow& operator=(ViewWindow&&) = default;

  /// Fills the window anew. `x`, `y`: where the body stands in its cell, 0 to 1; `yaw`: against the
  /// map's x axis.
  virtual void Project(const Panorama& panorama, double x, double y, double yaw) = 0;

  /// Cells from the middle to the edge.
  int reach() const { return reach_; }
  /// Points in the body's way, points below, and cells that were looked at or into.
  const sim::Grid<std::uint16_t>& obstacle_points() const { return obstacle_points_; }
  const sim::Grid<std::uint16_t>& floor_points() const { return floor_points_; }
  const sim::Grid<std::uint8_t>& seen() const { return seen_; }

 protected:
  explicit ViewWindow(int reach)
      : reach_(reach),
        obstacle_points_(2 * reach + 1),
        floor_points_(2 * reach + 1),
        seen_(2 * reach + 1) {}
  void Clear() {
    obstacle_points_.Fill(0);
    floor_points_.Fill(0);
    seen_.Fill(0);
  }

  int reach_;
  sim::Grid<std::uint16_t> obstacle_points_;
  sim::Grid<std::uint16_t> floor_points_;
  sim::Grid<std::uint8_t> seen_;
};

}  // namespace bulletnav::agent
