// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {

/// What a room is for; homes have those up to kStorage.
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
  kStorage,
  // Not in homes.
  kOpenOffice,
  kOffice,
  kMeetingRoom,
  kReception,
  kBreakRoom,
  kRestroom,
  kStockRoom,
  kTechnicalRoom,
  kWard,
  kExamRoom,
  kWaitingRoom,
  kShopFloor,
  kFittingRoom,
  kClassroom,
  kLaboratory,
  kCanteen,
  kHotelRoom,
  kLobby,
  kWorkshop,
  kWarehouse,
  kAssemblyHall,
  kPaintRoom,
  kStairwell,
  kStudio
};

template <>
struct EnumNames<RoomType> {
  static constexpr std::array kNames = {std::pair{"living_room", RoomType::kLivingRoom},
                                        std::pair{"kitchen", RoomType::kKitchen},
                                        std::pair{"dining_room", RoomType::kDiningRoom},
                                        std::pair{"bedroom", RoomType::kBedroom},
                                        std::pair{"kids_room", RoomType::kKidsRoom},
                                        std::pair{"bathroom", RoomType::kBathroom},
                                        std::pair{"toilet", RoomType::kToilet},
                                        std::pair{"corridor", RoomType::kCorridor},
                                        std::pair{"entry", RoomType::kEntry},
                                        std::pair{"study", RoomType::kStudy},
                                        std::pair{"laundry", RoomType::kLaundry},
                                        std::pair{"storage", RoomType::kStorage},
                                        std::pair{"open_office", RoomType::kOpenOffice},
                                        std::pair{"office", RoomType::kOffice},
                                        std::pair{"meeting_room", RoomType::kMeetingRoom},
                                        std::pair{"reception", RoomType::kReception},
                                        std::pair{"break_room", RoomType::kBreakRoom},
                                        std::pair{"restroom", RoomType::kRestroom},
                                        std::pair{"stock_room", RoomType::kStockRoom},
                                        std::pair{"technical_room", RoomType::kTechnicalRoom},
                                        std::pair{"ward", RoomType::kWard},
                                        std::pair{"exam_room", RoomType::kExamRoom},
                                        std::pair{"waiting_room", RoomType::kWaitingRoom},
                                        std::pair{"shop_floor", RoomType::kShopFloor},
                                        std::pair{"fitting_room", RoomType::kFittingRoom},
                                        std::pair{"classroom", RoomType::kClassroom},
                                        std::pair{"laboratory", RoomType::kLaboratory},
                                        std::pair{"canteen", RoomType::kCanteen},
                                        std::pair{"hotel_room", RoomType::kHotelRoom},
                                        std::pair{"lobby", RoomType::kLobby},
                                        std::pair{"workshop", RoomType::kWorkshop},
                                        std::pair{"warehouse", RoomType::kWarehouse},
                                        std::pair{"assembly_hall", RoomType::kAssemblyHall},
                                        std::pair{"paint_room", RoomType::kPaintRoom},
                                        std::pair{"stairwell", RoomType::kStairwell},
                                        std::pair{"studio", RoomType::kStudio}};
};

/// Plan coordinates are the world's (x, z) in metres, seen from above with x right and z down.
using PlanPoint = Eigen::Vector2f;

/// The direction to the left of someone who walks along `direction`, seen from above.
inline PlanPoint LeftOf(const PlanPoint& direction) {
  return {direction.y(), -direction.x()};
}

/// Area of a simple polygon, in either order.
float PolygonArea(std::span<const PlanPoint> outline);

/// Whether a point lies in a simple polygon.
bool IsInside(std::span<const PlanPoint> outline, const PlanPoint& point);

struct Room {
  RoomType type = RoomType::kLivingRoom;
  std::string name;                // unique in the house: "bedroom_2"
  std::vector<PlanPoint> outline;  // inner faces of its walls; rectilinear, no repeated points; the
                                   // room is to the left of someone walking along it (LeftOf)
  float area() const { return PolygonArea(outline); }
};

enum class OpeningKind { kDoor, kArch, kWindow };

template <>
struct EnumNames<OpeningKind> {
  static constexpr std::array kNames = {std::pair{"door", OpeningKind::kDoor},
                                        std::pair{"arch", OpeningKind::kArch},
                                        std::pair{"window", OpeningKind::kWindow}};
};

/// A hole in a wall. `a` and `b` are its jambs on the wall's middle line; walking from a to b,
/// room_a is to the left and room_b to the right.
struct Opening {
  OpeningKind kind = OpeningKind::kDoor;
  PlanPoint a = PlanPoint::Zero();
  PlanPoint b = PlanPoint::Zero();
  float bottom = 0.0f;  // of the hole above the floor: 0 for doors
  float top = 2.05f;
  float wall_thickness = 0.12f;
  int room_a = -1;          // index into FloorPlan::rooms
  int room_b = -1;          // -1: outside, as for every window and the entry door
  float door_angle = 0.0f;  // how far the leaf stands open, radians; 0 with has_leaf: shut
  bool has_leaf = false;
  bool hinge_at_a = true;    // else at b
  bool opens_into_a = true;  // the leaf swings into room_a, else into room_b

  float width() const { return (b - a).norm(); }
  bool IsPassage() const { return kind != OpeningKind::kWindow; }
};

inline constexpr float kLeafThickness = 0.04f;

/// Corners of a door's leaf seen from above, in order around it: the hinge edge on the face it
/// swings to, then along that face to the free edge, then back along the other face. Expects:
/// has_leaf (checked).
std::array<PlanPoint, 4> LeafOutline(const Opening& door);

/// A wall between two corners of its middle line. With its ends lengthened by half the thickness it
/// closes the corners.
struct Wall {
  PlanPoint a = PlanPoint::Zero();
  PlanPoint b = PlanPoint::Zero();
  float thickness = 0.12f;
  bool is_outer = false;
};

enum class Rail { kBars, kGlass, kBoards };

template <>
struct EnumNames<Rail> {
  static constexpr std::array kNames = {std::pair{"bars", Rail::kBars},
                                        std::pair{"glass", Rail::kGlass},
                                        std::pair{"boards", Rail::kBoards}};
};

/// A rectangular hole in a room's floor, closed below: where it has no rail the floor just ends.
/// Its edges: 0 near (from `corner` along `across`), 1 far, 2 at `corner`'s side, 3 opposite.
struct Pit {
  int room = -1;  // index into FloorPlan::rooms
  PlanPoint corner = PlanPoint::Zero();
  PlanPoint into = PlanPoint::Zero();    // unit, along `length`
  PlanPoint across = PlanPoint::Zero();  // unit, along `width`
  float length = 3.0f;
  float width = 2.0f;
  float depth = 2.0f;       // of its floor below the room's
  float first_drop = 0.0f;  // from the near edge down to the first step; 0: no flight goes down
  bool goes_up = false;     // a flight rises from the near edge, at the side of edge 3
  std::array<bool, 4> rails = {};  // where one stands
  Rail rail = Rail::kBars;

  /// Its corners in the plan.
  PlanPoint low() const { return corner.cwiseMin(corner + length * into + width * across); }
  PlanPoint high() const { return corner.cwiseMax(corner + length * into + width * across); }
  std::array<PlanPoint, 4> Outline() const;
};

/// The layout of one storey.
struct FloorPlan {
  std::vector<Room> rooms;
  std::vector<Wall> walls;
  std::vector<Opening> openings;
  std::vector<PlanPoint>
      footprint;  // outer faces of the outer walls, ordered like a room's outline
  float ceiling = 2.6f;
  std::vector<Pit> pits = {};  // none in homes

  float area() const;  // of the rooms together, pits too
};

}  // namespace bulletnav::sim
