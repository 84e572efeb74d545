// SPDX-License-Identifier: MIT
#include "benchmark/replay/replay_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "benchmark/base/json_cursor.h"
#include "benchmark/base/scene_names.h"
#include "benchmark/report/agent_title.h"

namespace bulletnav::bench {
namespace {

/// To a thousandth; null for what cannot be told.
Json Number(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return std::round(*value * 1e3) / 1e3 + 0.0;
}

double Sum(const std::vector<GoalMetrics>& goals, const char* measure) {
  double sum = 0.0;
  for (const GoalMetrics& goal : goals) sum += goal.Find(measure).value_or(0.0);
  return sum;
}

/// Numbers names in the order in which they come.
class Numbers {
 public:
  std::size_t Of(const std::string& name) {
    const auto [at, is_new] = numbers_.try_emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    return at->second;
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::string> names_;
};

/// What scenes are called.
std::vector<std::string> InOrder(const std::vector<std::string>& scenes) {
  const std::map<std::string, std::string> called = SceneNames(scenes);
  std::vector<std::string> names;
  names.reserve(scenes.size());
  for (const std::string& scene : scenes) names.push_back(called.at(scene));
  return names;
}

Json Values(const std::vector<GoalMetrics>& goals) {
  const auto value = [&](const char* measure) {
    return Number(EpisodeValue(FindMeasure(measure), goals));
  };
  const auto reached = std::count_if(goals.begin(), goals.end(), [](const GoalMetrics& goal) {
    return goal.success();
  });
  return {goals.size(),
          reached,
          value("spl"),
          value("soft_spl"),
          Number(Sum(goals, "start_distance")),
          Number(goals.back().Find("distance_to_goal")),
          Number(Sum(goals, "path_length")),
          Sum(goals, "steps"),
          Sum(goals, "collisions")};
}

}  // namespace

std::string RunName(const std::filesystem::path& folder) {
  return folder.has_filename() ? folder.filename().string()
                               : folder.parent_path().filename().string();
}

std::string RowsJson(const std::filesystem::path& folder, const RunConfig& config,
                     std::span<const AgentRow> agents, std::span<const ReplayRow> rows,
                     const ReplayNotes& notes) {
  Numbers names;
  Numbers scenes;
  Json list = Json::array();
  for (const ReplayRow& row : rows) {
    const EpisodeResult& one = row.result;
    Json item = {names.Of(one.key.agent),  one.key.setting, one.key.condition, one.key.seed,
                 scenes.Of(one.key.scene), one.key.episode};
    item.push_back(one.difficulty ? Json(DifficultyName(*one.difficulty)) : Json(nullptr));
    item.push_back(one.failure);
    for (Json& value : Values(one.goals)) item.push_back(std::move(value));
    item.push_back(row.scene_block);
    item.push_back(row.goal_block);
    item.push_back(row.seen);
    item.push_back(row.has_path ? 1 : 0);
    item.push_back(row.has_beliefs ? 1 : 0);
    list.push_back(std::move(item));
  }
  Json titles = Json::array();
  for (const std::string& agent : names.names())
    titles.push_back({agent, AgentTitle(agent, agents)});
  const Json json = {{"name", RunName(folder)},
                     {"folder", (folder.has_filename() ? folder : folder.parent_path()).string()},
                     {"success_distance", config.success_distance},
                     {"max_steps", config.max_steps},
                     {"agents", std::move(titles)},
                     {"scenes", scenes.names()},
                     {"scene_names", InOrder(scenes.names())},
                     {"notes", notes.notes},
                     {"to_play_again", notes.to_play_again},
                     {"columns", {"agent",          "setting",          "condition",   "seed",
                                  "scene",          "episode",          "difficulty",  "failure",
                                  "goals",          "reached",          "spl",         "soft_spl",
                                  "start_distance", "distance_to_goal", "path_length", "steps",
                                  "collisions",     "scene_block",      "goal_block",  "seen",
                                  "has_path",       "has_beliefs"}},
                     {"rows", std::move(list)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace bulletnav::bench
