// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "sim/house/placing/free_floor.h"
#include "sim/house/shell/room_shell.h"

namespace bulletnav::sim::placing {

using Box = Eigen::AlignedBox3f;  // of the world, metres

Rect FootOf(const Box& box);

/// What of a room is taken: by furniture, by doors and their swing, by the floor that furniture
/// wants free in front of it.
class RoomSpace {
 public:
  RoomSpace(const FloorPlan& plan, const HouseStyle& style, int room);

  const Room& room() const { return room_; }
  const std::vector<shell::Side>& sides() const { return sides_; }
  float ceiling() const { return ceiling_; }
  /// The largest rectangle of the floor, furniture or not.
  const Rect& main_floor() const { return main_floor_; }
  /// In front of each door, just inside the room; the house's front door first.
  const std::vector<PlanPoint>& mouths() const { return mouths_; }

  bool Contains(const Rect& rect) const { return placing::Contains(room_.outline, rect); }
  /// Meets no piece.
  bool IsFree(const Box& box) const;
  bool MeetsDoorway(const Rect& rect) const;
  bool MeetsClearance(const Rect& rect) const;
  /// Lies over a hole in the floor.
  bool MeetsPit(const Rect& rect) const;
  /// Stands before a window, or on a wall where a hole is.
  bool HidesOpening(const Box& box) const;
  /// Hangs on a wall that is as wide as the box, at least.
  bool HasWallBehind(const Box& box) const;
  /// Doors stay joined when this is added.
  bool LeavesWayPast(const Box& box) const;

  void Add(const Box& box, const std::optional<Rect>& clearance);

 private:
  /// The box around a box in a side's frame.
  Box SeenFrom(std::size_t side, const Box& box) const;
  void AddDoor(const FloorPlan& plan, const Opening& door);
  void FindMainFloor();

  const Room& room_;
  std::vector<shell::Side> sides_;
  std::vector<Eigen::Affine3f> side_frames_;
  float ceiling_;
  Rect main_floor_;
  std::vector<Box> taken_;
  std::vector<Rect> pits_;
  std::vector<Rect> doorways_;
  std::vector<Rect> clearances_;
  std::vector<PlanPoint> mouths_;
  std::optional<FreeFloor> grid_;
};

}  // namespace bulletnav::sim::placing
