// SPDX-License-Identifier: MIT
#include "sim/house/house_json.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "sim/base/files.h"
#include "sim/config/json_node.h"

namespace bulletnav::sim {
namespace {

using Json = FloatJson;
using Node = JsonNode<Json>;

constexpr float kAreaSlack = 0.01f;  // square metres; areas are said for people and checked

/// The openings one can walk through into a room.
std::vector<int> DoorsOf(const FloorPlan& plan, int room) {
  std::vector<int> doors;
  for (std::size_t i = 0; i < plan.openings.size(); ++i) {
    const Opening& opening = plan.openings[i];
    if (opening.IsPassage() && (opening.room_a == room || opening.room_b == room)) {
      doors.push_back(static_cast<int>(i));
    }
  }
  return doors;
}

Json PointJson(const PlanPoint& p) {
  return {p.x(), p.y()};
}

Json PolygonJson(std::span<const PlanPoint> outline) {
  Json json = Json::array();
  for (const PlanPoint& p : outline) json.push_back(PointJson(p));
  return json;
}

Json RoomIndexJson(int room) {
  return room < 0 ? Json(nullptr) : Json(room);
}

Json RoomsJson(const FloorPlan& plan) {
  Json json = Json::array();
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    const Room& room = plan.rooms[i];
    json.push_back({{"name", room.name},
                    {"type", NameOf(room.type)},
                    {"area_m2", room.area()},
                    {"doors", DoorsOf(plan, static_cast<int>(i))},
                    {"polygon", PolygonJson(room.outline)}});
  }
  return json;
}

Json LeafJson(const Opening& o) {
  if (!o.has_leaf) return nullptr;
  return {{"angle", o.door_angle},
          {"hinge", o.hinge_at_a ? "a" : "b"},
          {"opens_into", RoomIndexJson(o.opens_into_a ? o.room_a : o.room_b)}};
}

Json OpeningsJson(const FloorPlan& plan) {
  Json json = Json::array();
  for (const Opening& o : plan.openings) {
    json.push_back({{"kind", NameOf(o.kind)},
                    {"a", PointJson(o.a)},
                    {"b", PointJson(o.b)},
                    {"bottom", o.bottom},
                    {"top", o.top},
                    {"wall_thickness", o.wall_thickness},
                    {"rooms", {RoomIndexJson(o.room_a), RoomIndexJson(o.room_b)}},
                    {"leaf", LeafJson(o)}});
  }
  return json;
}

Json WallsJson(const FloorPlan& plan) {
  Json json = Json::array();
  for (const Wall& wall : plan.walls) {
    json.push_back({{"a", PointJson(wall.a)},
                    {"b", PointJson(wall.b)},
                    {"thickness", wall.thickness},
                    {"is_outer", wall.is_outer}});
  }
  return json;
}

Json PitsJson(const FloorPlan& plan) {
  Json json = Json::array();
  for (const Pit& pit : plan.pits) {
    json.push_back({{"room", pit.room},
                    {"corner", PointJson(pit.corner)},
                    {"into", PointJson(pit.into)},
                    {"across", PointJson(pit.across)},
                    {"length", pit.length},
                    {"width", pit.width},
                    {"depth", pit.depth},
                    {"first_drop", pit.first_drop},
                    {"goes_up", pit.goes_up},
                    {"rails", pit.rails},
                    {"rail", NameOf(pit.rail)}});
  }
  return json;
}

Json VectorJson(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

Json FurnitureJson(const std::vector<Furnishing>& furniture) {
  Json json = Json::array();
  for (const Furnishing& piece : furniture) {
    json.push_back({{"kind", piece.kind},
                    {"room", piece.room},
                    {"position", VectorJson(piece.position)},
                    {"yaw", piece.yaw},
                    {"low", VectorJson(piece.low)},
                    {"high", VectorJson(piece.high)}});
    if (!piece.name.empty()) json.back()["name"] = piece.name;
  }
  return json;
}

/// Lists of objects get a line an object, all else a line a key.
std::string Lines(const Json& json) {
  std::string text = "{";
  for (const auto& [key, value] : json.items()) {
    text += (text.size() > 1 ? ",\n \"" : "\n \"") + key + "\": ";
    if (!value.is_array() || value.empty() || !value[0].is_object()) {
      text += value.dump(-1, ' ', false, Json::error_handler_t::replace);
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      text += (i == 0 ? "[\n  " : ",\n  ") +
              value[i].dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    text += "]";
  }
  return text + "\n}\n";
}

PlanPoint ReadPoint(const Node& node) {
  if (node.Size() != 2) node.Fail("is not a pair [x, z]");
  return {node.Item(0).Number(), node.Item(1).Number()};
}

std::vector<PlanPoint> ReadPolygon(const Node& node) {
  std::vector<PlanPoint> outline;
  const std::size_t n = node.Size(3);
  for (std::size_t i = 0; i < n; ++i) outline.push_back(ReadPoint(node.Item(i)));
  if (!(PolygonArea(outline) > 0.0f)) node.Fail("encloses nothing");
  return outline;
}

void CheckArea(const Node& node, float area) {
  if (!(std::abs(node.Number() - area) <= kAreaSlack)) {
    node.Fail("is not the area of the shape, " + std::to_string(area));
  }
}

int ReadRoomIndex(const Node& node, std::size_t rooms) {
  return node.IsNull() ? -1 : node.Index(rooms, "rooms");
}

void ReadEnds(const Node& node, PlanPoint* a, PlanPoint* b) {
  *a = ReadPoint(node.At("a"));
  *b = ReadPoint(node.At("b"));
  if (*a == *b) node.Fail("has no length: a and b are the same point");
}

std::vector<Room> ReadRooms(const Node& node) {
  std::vector<Room> rooms;
  std::set<std::string> names;
  const std::size_t n = node.Size(1);
  for (std::size_t i = 0; i < n; ++i) {
    const Node item = node.Item(i);
    Room room;
    room.name = item.At("name").Text();
    if (!names.insert(room.name).second) item.At("name").Fail("'" + room.name + "' is there twice");
    room.type = item.At("type").Enum<RoomType>();
    room.outline = ReadPolygon(item.At("polygon"));
    CheckArea(item.At("area_m2"), room.area());
    rooms.push_back(std::move(room));
  }
  return rooms;
}

void ReadLeaf(const Node& node, std::size_t rooms, Opening* opening) {
  if (node.IsNull()) return;
  if (!opening->IsPassage()) node.Fail("belongs to a window, which has none");
  opening->has_leaf = true;
  opening->door_angle = node.At("angle").Number();
  const std::string hinge = node.At("hinge").Text();
  if (hinge != "a" && hinge != "b") node.At("hinge").Fail("'" + hinge + "' is not one of: a, b");
  opening->hinge_at_a = hinge == "a";
  const int into = ReadRoomIndex(node.At("opens_into"), rooms);
  if (into != opening->room_a && into != opening->room_b) {
    node.At("opens_into").Fail("is none of the two rooms of the door");
  }
  opening->opens_into_a = into == opening->room_a;
}

std::vector<Opening> ReadOpenings(const Node& node, std::size_t rooms) {
  std::vector<Opening> openings;
  const std::size_t n = node.Size();
  for (std::size_t i = 0; i < n; ++i) {
    const Node item = node.Item(i);
    Opening opening;
    opening.kind = item.At("kind").Enum<OpeningKind>();
    ReadEnds(item, &opening.a, &opening.b);
    opening.bottom = item.At("bottom").Number();
    opening.top = item.At("top").Number();
    if (!(opening.bottom < opening.top)) item.At("top").Fail("is not above the bottom");
    opening.wall_thickness = item.At("wall_thickness").Positive();
    const Node sides = item.At("rooms");
    if (sides.Size() != 2) sides.Fail("is not a pair of rooms");
    opening.room_a = sides.Item(0).Index(rooms, "rooms");
    opening.room_b = ReadRoomIndex(sides.Item(1), rooms);
    if (opening.room_a == opening.room_b) sides.Fail("are the same room twice");
    ReadLeaf(item.At("leaf"), rooms, &opening);
    openings.push_back(opening);
  }
  return openings;
}

std::vector<Wall> ReadWalls(const Node& node) {
  std::vector<Wall> walls;
  const std::size_t n = node.Size();
  for (std::size_t i = 0; i < n; ++i) {
    Wall wall;
    ReadEnds(node.Item(i), &wall.a, &wall.b);
    wall.thickness = node.Item(i).At("thickness").Positive();
    wall.is_outer = node.Item(i).At("is_outer").Truth();
    walls.push_back(wall);
  }
  return walls;
}

std::vector<Pit> ReadPits(const Node& node, std::size_t rooms) {
  std::vector<Pit> pits;
  const std::size_t n = node.Size();
  for (std::size_t i = 0; i < n; ++i) {
    const Node item = node.Item(i);
    Pit pit;
    pit.room = item.At("room").Index(rooms, "rooms");
    pit.corner = ReadPoint(item.At("corner"));
    pit.into = ReadPoint(item.At("into"));
    pit.across = ReadPoint(item.At("across"));
    pit.length = item.At("length").Positive();
    pit.width = item.At("width").Positive();
    pit.depth = item.At("depth").Positive();
    pit.first_drop = item.At("first_drop").Number();
    pit.goes_up = item.At("goes_up").Truth();
    const Node rails = item.At("rails");
    if (rails.Size() != pit.rails.size()) rails.Fail("are not four, one an edge");
    for (std::size_t k = 0; k < pit.rails.size(); ++k) pit.rails[k] = rails.Item(k).Truth();
    pit.rail = item.At("rail").Enum<Rail>();
    pits.push_back(pit);
  }
  return pits;
}

Eigen::Vector3f ReadVector(const Node& node) {
  if (node.Size() != 3) node.Fail("is not a place [x, y, z]");
  return {node.Item(0).Number(), node.Item(1).Number(), node.Item(2).Number()};
}

std::vector<Furnishing> ReadFurniture(const Node& node, std::size_t rooms) {
  std::vector<Furnishing> furniture;
  const std::size_t n = node.Size();
  furniture.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Node item = node.Item(i);
    Furnishing piece;
    piece.kind = item.At("kind").Text();
    piece.room = item.At("room").Index(rooms, "rooms");
    piece.position = ReadVector(item.At("position"));
    piece.yaw = item.At("yaw").Number();
    piece.low = ReadVector(item.At("low"));
    piece.high = ReadVector(item.At("high"));
    if ((piece.high - piece.low).minCoeff() < 0.0f) item.At("high").Fail("is below low");
    if (item.Has("name")) piece.name = item.At("name").Text();
    furniture.push_back(std::move(piece));
  }
  return furniture;
}

/// The rooms' doors follow from the openings: they are said for people and checked.
void CheckDoors(const Node& rooms, const FloorPlan& plan) {
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    const Node doors = rooms.Item(i).At("doors");
    std::vector<int> found;
    const std::size_t n = doors.Size();
    for (std::size_t k = 0; k < n; ++k) {
      found.push_back(doors.Item(k).Index(plan.openings.size(), "openings"));
    }
    if (found != DoorsOf(plan, static_cast<int>(i))) {
      doors.Fail("are not the doors and arches that name this room, in order");
    }
  }
}

}  // namespace

std::string ToJson(const HouseDescription& house) {
  const FloorPlan& plan = house.plan;
  Json json = {{"seed", house.seed},       {"style", house.style},
               {"ceiling", plan.ceiling},  {"area_m2", plan.area()},
               {"rooms", RoomsJson(plan)}, {"openings", OpeningsJson(plan)},
               {"walls", WallsJson(plan)}, {"footprint", PolygonJson(plan.footprint)}};
  if (!house.kind.empty()) json["kind"] = house.kind;
  if (!plan.pits.empty()) json["pits"] = PitsJson(plan);
  if (!house.furniture.empty()) json["furniture"] = FurnitureJson(house.furniture);
  return Lines(json);
}

HouseDescription ReadHouseJson(const std::filesystem::path& file) {
  const std::string remedy = "generate the house again, or delete this file";
  const Json document = ParseJson<Json>(ReadTextFile(file), file, 1, remedy);
  const Node root(document, file, "", remedy);
  HouseDescription house;
  house.seed = root.At("seed").Whole();
  house.style = root.At("style").Text();
  house.plan.ceiling = root.At("ceiling").Positive();
  house.plan.rooms = ReadRooms(root.At("rooms"));
  CheckArea(root.At("area_m2"), house.plan.area());
  house.plan.openings = ReadOpenings(root.At("openings"), house.plan.rooms.size());
  CheckDoors(root.At("rooms"), house.plan);
  house.plan.walls = ReadWalls(root.At("walls"));
  house.plan.footprint = ReadPolygon(root.At("footprint"));
  if (root.Has("pits")) house.plan.pits = ReadPits(root.At("pits"), house.plan.rooms.size());
  if (root.Has("kind")) house.kind = root.At("kind").Text();
  if (root.Has("furniture")) {
    house.furniture = ReadFurniture(root.At("furniture"), house.plan.rooms.size());
  }
  return house;
}

}  // namespace bulletnav::sim
