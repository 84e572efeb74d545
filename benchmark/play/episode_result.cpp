// SPDX-License-Identifier: MIT
#include "benchmark/play/episode_result.h"

#include <cmath>
#include <limits>

#include "benchmark/base/json_cursor.h"
#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

Json Finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

void WriteMetrics(const GoalMetrics& metrics, Json* json) {
  (*json)["success"] = metrics.success;
  (*json)["success_euclidean"] = metrics.success_euclidean;
  (*json)["spl"] = metrics.spl;
  (*json)["soft_spl"] = metrics.soft_spl;
  (*json)["start_distance"] = metrics.start_distance;
  (*json)["distance_to_goal"] = Finite(metrics.distance_to_goal);
  (*json)["euclidean_distance"] = metrics.euclidean_distance;
  (*json)["path_length"] = metrics.path_length;
  (*json)["steps"] = metrics.steps;
  (*json)["collisions"] = metrics.collisions;
}

bool Truth(const JsonCursor& json) {
  if (!json.value().is_boolean()) json.Fail("expected true or false here");
  return json.value().get<bool>();
}

template <class Integer>
Integer Whole(const JsonCursor& json) {
  if (!json.value().is_number_unsigned()) json.Fail("expected a whole number here");
  const auto value = json.value().get<std::uint64_t>();
  if (value > static_cast<std::uint64_t>(std::numeric_limits<Integer>::max())) {
    json.Fail("is too large a number");
  }
  return static_cast<Integer>(value);
}

GoalMetrics ReadMetrics(const JsonCursor& json) {
  GoalMetrics metrics;
  metrics.success = Truth(json.At("success"));
  metrics.success_euclidean = Truth(json.At("success_euclidean"));
  metrics.spl = json.At("spl").Number();
  metrics.soft_spl = json.At("soft_spl").Number();
  metrics.start_distance = json.At("start_distance").Number();
  const JsonCursor distance = json.At("distance_to_goal");
  metrics.distance_to_goal =
      distance.value().is_null() ? std::numeric_limits<double>::infinity() : distance.Number();
  metrics.euclidean_distance = json.At("euclidean_distance").Number();
  metrics.path_length = json.At("path_length").Number();
  metrics.steps = Whole<int>(json.At("steps"));
  metrics.collisions = Whole<int>(json.At("collisions"));
  return metrics;
}

EpisodeResult FromJson(const JsonCursor& json) {
  EpisodeResult result;
  result.key.agent = json.At("agent").Text();
  result.key.setting = json.At("setting").Text();
  result.key.condition = json.At("condition").Text();
  result.key.seed = Whole<std::uint64_t>(json.At("seed"));
  result.key.scene = json.At("scene").Text();
  result.key.episode = json.At("episode").Text();
  if (!json.At("difficulty").value().is_null()) {
    result.difficulty = DifficultyNamed(json.At("difficulty").Text());
  }
  if (!json.At("failure").value().is_null()) result.failure = json.At("failure").Text();
  if (!json.Has("goals")) {
    result.goals = {ReadMetrics(json)};
    return result;
  }
  const JsonCursor goals = json.At("goals");
  goals.ExpectList();
  for (std::size_t i = 0; i < goals.value().size(); ++i) {
    result.goals.push_back(ReadMetrics(goals.Item(i)));
  }
  return result;
}

}  // namespace

std::string ToJsonLine(const EpisodeResult& result) {
  CHECK(!result.goals.empty());
  Json json = {
      {"agent", result.key.agent},
      {"setting", result.key.setting},
      {"condition", result.key.condition},
      {"seed", result.key.seed},
      {"scene", result.key.scene},
      {"episode", result.key.episode},
      {"difficulty", result.difficulty ? Json(DifficultyName(*result.difficulty)) : Json()},
      {"failure", result.failure.empty() ? Json() : Json(result.failure)}};
  if (result.goals.size() == 1) {
    WriteMetrics(result.goals[0], &json);
  } else {
    for (const GoalMetrics& metrics : result.goals)
      WriteMetrics(metrics, &json["goals"].emplace_back());
  }
  // What an agent says of its failure may be no UTF-8.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

EpisodeResult FromJsonLine(std::string_view line, const std::filesystem::path& file,
                           int line_number) {
  const std::filesystem::path place = file.string() + ":" + std::to_string(line_number);
  const Json json = ParseJson(line, file, line_number);
  return FromJson({json, place, ""});
}

}  // namespace bulletnav::bench
