// SPDX-License-Identifier: MIT
#include "benchmark/replay/replay_scene.h"

#include <cmath>
#include <span>

#include "benchmark/base/json_cursor.h"
#include "benchmark/replay/base64.h"
#include "benchmark/report/room_labels.h"

namespace bulletnav::bench {
namespace {

double Centimetres(float value) {
  return std::round(static_cast<double>(value) * 100.0) / 100.0 + 0.0;
}

Json Flat(std::span<const Eigen::Vector2f> points) {
  Json list = Json::array();
  for (const Eigen::Vector2f& p : points) {
    list.push_back(Centimetres(p.x()));
    list.push_back(Centimetres(p.y()));
  }
  return list;
}

void AddPlan(const sim::FloorPlan& plan, Json* json) {
  for (const char* name : {"walls", "rooms", "names", "holes", "leaves"}) {
    (*json)[name] = Json::array();
  }
  for (const sim::Wall& wall : plan.walls) {
    Json item = Flat(std::array{wall.a, wall.b});
    item.push_back(Centimetres(wall.thickness));
    (*json)["walls"].push_back(std::move(item));
  }
  for (const sim::Room& room : plan.rooms) (*json)["rooms"].push_back(Flat(room.outline));
  for (const MapLabel& label : RoomLabels(plan)) {
    (*json)["names"].push_back({label.text, Centimetres(label.at.x()), Centimetres(label.at.y())});
  }
  for (const sim::Opening& hole : plan.openings) {
    Json item = Flat(std::array{hole.a, hole.b});
    for (const float value : {hole.wall_thickness, hole.bottom, hole.top}) {
      item.push_back(Centimetres(value));
    }
    item.push_back(hole.IsPassage() ? 1 : 0);
    (*json)["holes"].push_back(std::move(item));
    if (hole.has_leaf) (*json)["leaves"].push_back(Flat(sim::LeafOutline(hole)));
  }
}

}  // namespace

std::string SceneJson(const SceneMap& map) {
  const auto& [origin, pixel] = map.frame;
  Json json;
  json["low"] = Flat(std::array{origin});
  json["size"] = Flat(std::array{Eigen::Vector2f(pixel * static_cast<float>(map.backdrop.width),
                                                 pixel * static_cast<float>(map.backdrop.height))});
  json["picture"] = "data:image/png;base64," + Base64(sim::EncodePng(map.backdrop));
  json["walk"] = Flat(map.walkable);
  json["cuts"] = Flat(map.sections);
  if (map.plan) AddPlan(*map.plan, &json);
  return json.dump();
}

}  // namespace bulletnav::bench
