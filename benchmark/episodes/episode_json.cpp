// SPDX-License-Identifier: MIT
#include "benchmark/episodes/episode_json.h"

#include <cmath>

namespace bulletnav::bench {
namespace {

constexpr double kUnitTolerance = 1e-3;  // files hold single-precision quaternions

Eigen::Vector3d ReadPosition(const JsonCursor& json) {
  json.ExpectList(3);
  return {json.Item(0).Number(), json.Item(1).Number(), json.Item(2).Number()};
}

Rotation ReadRotation(const JsonCursor& json) {
  json.ExpectList(4);
  const Rotation r = {json.Item(0).Number(), json.Item(1).Number(), json.Item(2).Number(),
                      json.Item(3).Number()};
  if (std::abs(std::hypot(std::hypot(r.x, r.y), std::hypot(r.z, r.w)) - 1.0) > kUnitTolerance) {
    json.Fail("is not a unit quaternion (x, y, z, w)");
  }
  if (std::hypot(r.x, r.z) > kUnitTolerance) {
    json.Fail("tilts the body; only turns about y, as in (0, sin, 0, cos), can be used");
  }
  return r;
}

std::optional<double> ReadRadius(const JsonCursor& goal) {
  if (!goal.Has("radius") || goal.value().at("radius").is_null()) return std::nullopt;
  const double radius = goal.At("radius").Number();
  if (radius < 0.0) goal.At("radius").Fail("a radius cannot be negative");
  return radius;
}

double ReadDistance(const JsonCursor& holder) {
  const double distance = holder.At("geodesic_distance").Number();
  if (distance < 0.0) holder.At("geodesic_distance").Fail("a distance cannot be negative");
  return distance;
}

EpisodeGoal ReadFurtherGoal(const JsonCursor& json) {
  EpisodeGoal goal;
  goal.position = ReadPosition(json.At("position"));
  if (json.Has("rotation")) goal.rotation = ReadRotation(json.At("rotation"));
  goal.radius = ReadRadius(json);
  goal.geodesic_distance = ReadDistance(json);
  return goal;
}

std::vector<EpisodeGoal> ReadGoals(const JsonCursor& json) {
  const JsonCursor list = json.At("goals");
  if (list.Size() != 1) {
    list.Fail("has " + std::to_string(list.Size()) +
              " goals; exactly one is read, a sequence goes into info.further_goals");
  }
  const JsonCursor info = json.At("info");
  EpisodeGoal first;
  first.position = ReadPosition(list.Item(0).At("position"));
  first.radius = ReadRadius(list.Item(0));
  first.geodesic_distance = ReadDistance(info);
  if (info.Has("goal_rotation")) first.rotation = ReadRotation(info.At("goal_rotation"));
  std::vector<EpisodeGoal> goals = {first};
  if (!info.Has("further_goals")) return goals;
  const JsonCursor further = info.At("further_goals");
  for (std::size_t i = 0; i < further.Size(); ++i) {
    goals.push_back(ReadFurtherGoal(further.Item(i)));
  }
  return goals;
}

Json ToJson(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}
Json ToJson(const Rotation& r) {
  return {r.x, r.y, r.z, r.w};
}
Json ToJson(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json FurtherGoalToJson(const EpisodeGoal& goal) {
  Json json = {{"position", ToJson(goal.position)}};
  if (goal.rotation) json["rotation"] = ToJson(*goal.rotation);
  json["radius"] = ToJson(goal.radius);
  json["geodesic_distance"] = goal.geodesic_distance;
  return json;
}

/// What the typed members say, and nothing else.
Json BareJson(const Episode& episode) {
  const EpisodeGoal& goal = episode.goals.at(0);
  Json info = {{"geodesic_distance", goal.geodesic_distance}};
  if (episode.difficulty) info["difficulty"] = DifficultyName(*episode.difficulty);
  if (goal.rotation) info["goal_rotation"] = ToJson(*goal.rotation);
  for (std::size_t i = 1; i < episode.goals.size(); ++i) {
    info["further_goals"].push_back(FurtherGoalToJson(episode.goals[i]));
  }
  Json goals = Json::array();
  goals.push_back({{"position", ToJson(goal.position)}, {"radius", ToJson(goal.radius)}});
  return {{"episode_id", episode.id},
          {"scene_id", episode.scene},
          {"start_position", ToJson(episode.start_position)},
          {"start_rotation", ToJson(episode.start_rotation)},
          {"info", info},
          {"goals", goals}};
}

/// Puts the values of `fresh` into `old`, leaving alone what is equal already (a 0 stays a 0 where
/// 0.0 would do) and what `fresh` does not speak of.
void Overlay(const Json& fresh, Json* old) {
  if (*old == fresh) return;
  if (old->is_object() && fresh.is_object()) {
    for (const auto& [key, value] : fresh.items()) Overlay(value, &(*old)[key]);
  } else if (old->is_array() && fresh.is_array() && old->size() == fresh.size()) {
    for (std::size_t i = 0; i < fresh.size(); ++i) Overlay(fresh[i], &(*old)[i]);
  } else {
    *old = fresh;
  }
}

}  // namespace

Episode EpisodeFromJson(const JsonCursor& json) {
  Episode episode;
  episode.id = json.At("episode_id").Text();
  if (episode.id.empty()) json.At("episode_id").Fail("is empty");
  episode.scene = json.At("scene_id").Text();
  if (episode.scene.empty()) json.At("scene_id").Fail("is empty; name the scene's mesh file");
  episode.start_position = ReadPosition(json.At("start_position"));
  episode.start_rotation = ReadRotation(json.At("start_rotation"));
  episode.goals = ReadGoals(json);
  const JsonCursor info = json.At("info");
  if (info.Has("difficulty") && info.value().at("difficulty").is_string()) {
    episode.difficulty = DifficultyNamed(info.At("difficulty").Text());
  }
  const std::string text = json.value().dump();
  if (text != BareJson(episode).dump()) episode.source = text;
  return episode;
}

Json EpisodeToJson(const Episode& episode) {
  Json bare = BareJson(episode);
  if (episode.source.empty()) return bare;
  Json json = Json::parse(episode.source);
  Overlay(bare, &json);
  return json;
}

}  // namespace bulletnav::bench
