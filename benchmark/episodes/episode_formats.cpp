// SPDX-License-Identifier: MIT
#include "benchmark/episodes/episode_formats.h"

#include "benchmark/episodes/episode.h"

namespace bulletnav::bench {
namespace {

bool HasFirstGoal(const Json& episode) {
  return episode.contains("goals") && episode["goals"].is_array() && !episode["goals"].empty() &&
         episode["goals"][0].is_object();
}

/// Moves a member of one object into another, under a new name. References into `to` do not last:
/// its members lie in one block of memory.
void MoveKey(const char* key, Json* from, const char* new_key, Json* to) {
  if (!from->is_object() || !from->contains(key)) return;
  Json value = std::move((*from)[key]);
  from->erase(key);
  (*to)[new_key] = std::move(value);
}

Json ListForm(Json episode, std::size_t number) {
  const std::string id = episode["episode_id"].get<std::string>();
  episode["episode_id"] = number;
  if (id != std::to_string(number)) episode["info"]["episode_id"] = id;
  Json& goal = episode["goals"][0];
  if (!goal["radius"].is_null()) episode["info"]["goal_radius"] = goal["radius"];
  goal["radius"] = nullptr;
  return episode;
}

Json NrnsForm(Json episode) {
  Json& goal = episode["goals"][0];
  // Absent and null both mean that there is none.
  if (goal["radius"].is_null()) goal.erase("radius");
  MoveKey("goal_rotation", &episode["info"], "rotation", &goal);
  MoveKey("geodesic_distance", &episode["info"], "length_shortest", &episode);
  return episode;
}

Json FromList(Json episode) {
  episode["episode_id"] = episode["episode_id"].dump();
  if (!episode.contains("info") || !episode["info"].is_object()) return episode;
  MoveKey("episode_id", &episode["info"], "episode_id", &episode);
  if (HasFirstGoal(episode)) {
    MoveKey("goal_radius", &episode["info"], "radius", &episode["goals"][0]);
  }
  return episode;
}

Json FromNrns(Json episode) {
  Json old = episode.contains("info") ? episode["info"] : Json::object();
  if (!old.is_object()) return episode;
  // In the order in which episodes are written, so that there and back changes nothing.
  Json info = Json::object();
  MoveKey("length_shortest", &episode, "geodesic_distance", &info);
  MoveKey("difficulty", &old, "difficulty", &info);
  if (HasFirstGoal(episode)) {
    Json& goal = episode["goals"][0];
    MoveKey("rotation", &goal, "goal_rotation", &info);
    if (!goal.contains("radius")) goal["radius"] = nullptr;
  }
  info.update(old);
  episode["info"] = std::move(info);
  return episode;
}

}  // namespace

Json ToHabitatForm(Json episode) {
  if (!episode.is_object()) return episode;
  if (episode.contains("length_shortest")) return FromNrns(std::move(episode));
  if (episode.contains("episode_id") && episode["episode_id"].is_number_integer()) {
    return FromList(std::move(episode));
  }
  return episode;
}

Json FromHabitatForm(const Json& episode, EpisodeFormat format, std::size_t number) {
  switch (format) {
    case EpisodeFormat::kHabitat:
      return episode;
    case EpisodeFormat::kList:
      return ListForm(episode, number);
    case EpisodeFormat::kNrns:
      return NrnsForm(episode);
  }
  return episode;
}

}  // namespace bulletnav::bench
