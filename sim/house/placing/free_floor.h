// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/house/floor_plan.h"

namespace bulletnav::sim::placing {

using Rect = Eigen::AlignedBox2f;  // of the plan, (x, z) in metres

/// Whether a rectangle lies inside a rectilinear outline.
bool Contains(std::span<const PlanPoint> outline, const Rect& rect);

/// Where a body can walk in one room: cells of 5 cm that are `margin` away from walls and
/// furniture. Furniture may neither part the doors from each other nor cut off a corner.
class FreeFloor {
 public:
  /// `mouths`: the places in front of the doors, which stay free; `leaves`: doors that stand open.
  /// The margin is lowered to the body's radius where doors are not joined without furniture; what
  /// cannot be reached even then does not count.
  FreeFloor(const Room& room, std::vector<PlanPoint> mouths, std::span<const Rect> leaves,
            float margin);

  bool StaysJoinedWith(const Rect& obstacle) const;
  void Block(const Rect& obstacle);

 private:
  void FindFloor(std::span<const Rect> leaves);
  void CloseUnreachable();
  void Mark(const Rect& obstacle, std::vector<char>* open) const;
  bool IsJoined(std::vector<char> open) const;
  int CellOf(const PlanPoint& point) const;
  PlanPoint CentreOf(int cell) const;
  /// Closes the cells that can be reached from the first mouth.
  void Flood(std::vector<char>* open) const;

  const Room& room_;
  std::vector<PlanPoint> mouths_;
  float margin_;
  PlanPoint origin_ = PlanPoint::Zero();
  int cols_ = 0;
  int rows_ = 0;
  std::vector<char> open_;
};

}  // namespace bulletnav::sim::placing
