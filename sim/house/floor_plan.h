// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {

enum class RoomType {
  kLivingRoom,
  kKitchen,
  kDiningRoom,
  kBedroom,
  kKidsRoom,
  kBathroom,
  kToilet,
  kCorridor,
  kEntry,
  kStudy,
  kLaundry,
  kStorage
};

template <>
struct EnumNames<RoomType> {
  static constexpr std::array kNames = {
      std::pair{"living_room", RoomType::kLivingRoom}, std::pair{"kitchen", RoomType::kKitchen},
      std::pair{"dining_room", RoomType::kDiningRoom}, std::pair{"bedroom", RoomType::kBedroom},
      std::pair{"kids_room", RoomType::kKidsRoom},     std::pair{"bathroom", RoomType::kBathroom},
      std::pair{"toilet", RoomType::kToilet},          std::pair{"corridor", RoomType::kCorridor},
      std::pair{"entry", RoomType::kEntry},            std::pair{"study", RoomType::kStudy},
      std::pair{"laundry", RoomType::kLaundry},        std::pair{"storage", RoomType::kStorage}};
};

/// Plan coordinates are the world's (x, z) in metres, seen from above with x right and z down.
using PlanPoint = Eigen::Vector2f;

struct Room {
  RoomType type = RoomType::kLivingRoom;
  std::string name;                // unique in the house: "bedroom_2"
  std::vector<PlanPoint> outline;  // inner faces of its walls; rectilinear, no repeated points,
                                   // the room on the left when walking along it in (x, z)
  float area() const;
};

enum class OpeningKind { kDoor, kArch, kWindow };

/// A hole in a wall. `a` and `b` are its jambs on the wall's middle line.
struct Opening {
  OpeningKind kind = OpeningKind::kDoor;
  PlanPoint a = PlanPoint::Zero();
  PlanPoint b = PlanPoint::Zero();
  float bottom = 0.0f;         // of the hole above the floor: 0 for doors
  float top = 2.05f;
  int room_a = -1;             // rooms on its sides, -1 outside
  int room_b = -1;
  float door_angle = 0.0f;     // how far the leaf stands open, radians; 0 with has_leaf: shut
  bool has_leaf = false;
  bool hinge_at_a = true;      // else at b
  bool opens_into_a = true;    // the leaf swings into room_a, else into room_b
};

/// A wall between two corners of its middle line.
struct Wall {
  PlanPoint a = PlanPoint::Zero();
  PlanPoint b = PlanPoint::Zero();
  float thickness = 0.12f;
  bool is_outer = false;
};

/// The layout of one storey.
struct FloorPlan {
  std::vector<Room> rooms;
  std::vector<Wall> walls;
  std::vector<Opening> openings;
  float ceiling = 2.6f;
  float area() const;  // of the rooms together
};

}  // namespace bulletnav::sim
