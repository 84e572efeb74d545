// SPDX-License-Identifier: MIT
#include "benchmark/play/episode_result.h"

#include <cmath>
#include <limits>

#include "benchmark/base/json_cursor.h"
#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kMostWhole = std::numeric_limits<int>::max();

Json ValueToJson(double value, MeasureKind kind) {
  switch (kind) {
    case MeasureKind::kYesNo:
      return value != 0.0;
    case MeasureKind::kWhole:
      return static_cast<std::int64_t>(value);
    case MeasureKind::kReal:
    case MeasureKind::kRealOrInfinite:
      return std::isfinite(value) ? Json(value) : Json(nullptr);
  }
  return {};
}

void WriteMetrics(const GoalMetrics& metrics, Json* json) {
  for (const Measure& measure : AllMeasures()) {
    const std::string name(measure.name);
    BULLETNAV_CHECK(!json->contains(name));  // a measure called like a part of the key
    const std::optional<double> value = metrics.Find(name);
    if (value) (*json)[name] = ValueToJson(*value, measure.kind);
  }
}

double ReadValue(const JsonCursor& json, MeasureKind kind) {
  switch (kind) {
    case MeasureKind::kYesNo:
      return json.Truth() ? 1.0 : 0.0;
    case MeasureKind::kWhole:
      return static_cast<double>(json.Whole(kMostWhole));
    case MeasureKind::kReal:
      return json.Number();
    case MeasureKind::kRealOrInfinite:
      return json.IsNull() ? std::numeric_limits<double>::infinity() : json.Number();
  }
  return 0.0;
}

/// Older programs had fewer measures, newer ones may have more.
GoalMetrics ReadMetrics(const JsonCursor& json) {
  GoalMetrics metrics;
  for (const Measure& measure : AllMeasures()) {
    const std::string name(measure.name);
    if (json.Has(name.c_str())) metrics[name] = ReadValue(json.At(name.c_str()), measure.kind);
  }
  json.At("success");  // which all had
  return metrics;
}

EpisodeResult FromJson(const JsonCursor& json) {
  EpisodeResult result;
  result.key.agent = json.At("agent").Text();
  result.key.setting = json.At("setting").Text();
  result.key.condition = json.At("condition").Text();
  result.key.seed = json.At("seed").Whole();
  result.key.scene = json.At("scene").Text();
  result.key.episode = json.At("episode").Text();
  if (!json.At("difficulty").IsNull()) {
    result.difficulty = DifficultyNamed(json.At("difficulty").Text());
  }
  if (!json.At("failure").IsNull()) result.failure = json.At("failure").Text();
  if (!json.Has("goals")) {
    result.goals = {ReadMetrics(json)};
    return result;
  }
  const JsonCursor goals = json.At("goals");
  for (std::size_t i = 0; i < goals.Size(); ++i) {
    result.goals.push_back(ReadMetrics(goals.Item(i)));
  }
  return result;
}

}  // namespace

std::string ToJsonLine(const EpisodeResult& result) {
  BULLETNAV_CHECK(!result.goals.empty());
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
