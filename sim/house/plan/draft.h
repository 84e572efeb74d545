// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <vector>

#include "sim/house/floor_plan.h"

namespace bulletnav::sim::plan {

/// Rectangle in whole centimetres; x right, y down the plan (the world's z). Rooms of a draft touch
/// each other along the middle lines of inner walls; what is clear is smaller by one wall thickness
/// in each direction, along outside walls too.
struct Box {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

struct DraftRoom {
  RoomType type = RoomType::kLivingRoom;
  float target = 0.0f;     // wanted clear area, m2
  std::vector<Box> boxes;  // disjoint, together one region
};

inline constexpr int kOutside = -1;

/// Who lies where, before there are walls.
struct Draft {
  std::vector<DraftRoom> rooms;
  int wall_cm = 12;   // thickness of inner walls, even
  int outer_cm = 24;  // of outer walls; what they have more lies outside

  /// Clear length in metres of `cm` between middle lines.
  float Clear(int cm) const { return 0.01f * static_cast<float>(cm - wall_cm); }
  /// The other way, rounded up to the grid.
  int Gross(float metres) const;
  RoomType type(int room) const { return rooms[static_cast<std::size_t>(room)].type; }
  Box Bounds(int room) const;
};

/// Draft coordinates are multiples of this, centimetres.
inline constexpr int kGrid = 5;
int SnapToGrid(double cm);

/// A straight stretch of middle line between the same two regions.
struct Border {
  bool is_vertical = false;
  int at = 0;    // x of a vertical one, y of a level one
  int from = 0;  // y or x, from < to
  int to = 0;
  int low = kOutside;  // room on its side of smaller x or y
  int high = kOutside;

  int length() const { return to - from; }
  bool Joins(int a, int b) const { return (low == a && high == b) || (low == b && high == a); }
};

struct GridPoint {
  int x = 0;
  int y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
  friend bool operator<(const GridPoint& a, const GridPoint& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }
};

/// A draft cut along every edge of every box: which room owns each cell. A snapshot.
class CellGrid {
 public:
  explicit CellGrid(const Draft& draft);

  /// Two boxes share ground.
  bool HasOverlaps() const { return overlaps_; }
  /// Two cells of one region (or of the outside) meet in a corner only.
  bool HasPinches() const;
  /// Room at a point that is on no border.
  int RoomAt(int x, int y) const;
  /// All borders, those against the outside too, in a fixed order.
  std::vector<Border> Borders() const;
  /// Corners of the region where `is_inside` holds, walking with the region to the left (LeftOf).
  /// Empty if it is not one piece without holes.
  std::vector<GridPoint> Outline(const std::function<bool(int)>& is_inside) const;

 private:
  int columns() const { return static_cast<int>(xs_.size()) - 1; }
  int rows() const { return static_cast<int>(ys_.size()) - 1; }
  int Cell(int column, int row) const;
  std::size_t Index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(column);
  }
  void Mark(const Box& box, int room);
  /// The borders along one grid line: a column's left edge or a row's upper edge.
  void AddLine(bool is_vertical, int line, std::vector<Border>* borders) const;

  std::vector<int> xs_;
  std::vector<int> ys_;
  std::vector<int> cells_;
  bool overlaps_ = false;
};

}  // namespace bulletnav::sim::plan
