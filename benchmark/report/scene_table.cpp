// SPDX-License-Identifier: MIT
#include "benchmark/report/scene_table.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/base/scene_names.h"
#include "benchmark/play/condition.h"
#include "benchmark/play/measure.h"
#include "benchmark/play/metrics.h"
#include "benchmark/report/agent_title.h"
#include "sim/config/enum_names.h"

namespace bulletnav::bench {
namespace {

constexpr std::size_t kMostScenes = 40;

struct Sums {
  int episodes = 0;
  double success = 0.0;
  double spl = 0.0;
};
using Cells = std::map<std::string, Sums>;                            // by agent
using Places = std::map<std::pair<std::string, std::string>, Cells>;  // by setting and scene

std::optional<std::string> FirstCondition(std::span<const EpisodeResult> results) {
  for (const auto& [name, condition] : sim::EnumNames<Condition>::kNames) {
    const auto has_it = [&, wanted = name](const EpisodeResult& result) {
      return result.key.condition == wanted;
    };
    if (std::any_of(results.begin(), results.end(), has_it)) return std::string(name);
  }
  return std::nullopt;
}

Places Gather(std::span<const EpisodeResult> results, const std::string& condition) {
  Places places;
  for (const EpisodeResult& result : results) {
    if (result.key.condition != condition) continue;
    Sums& sums = places[{result.key.setting, result.key.scene}][result.key.agent];
    ++sums.episodes;
    sums.success += EpisodeValue(FindMeasure("success"), result.goals).value_or(0.0);
    sums.spl += EpisodeValue(FindMeasure("spl"), result.goals).value_or(0.0);
  }
  return places;
}

/// In the order of the run.
std::vector<std::string> AgentsIn(const Places& places, std::span<const AgentRow> agents) {
  std::vector<std::string> names;
  for (const AgentRow& agent : agents) {
    const auto plays = [&](const auto& place) {
      return place.second.contains(agent.agent);
    };
    if (std::any_of(places.begin(), places.end(), plays)) names.push_back(agent.agent);
  }
  return names;
}

ResultsTable::Row RowOf(const std::string& setting, const std::string& label, const Cells& cells,
                        const std::vector<std::string>& names) {
  ResultsTable::Row row = {SettingTitle(setting), label, false, {}, ""};
  int episodes = 0;
  for (const std::string& name : names) {
    const auto found = cells.find(name);
    const Sums sums = found == cells.end() ? Sums() : found->second;
    episodes = std::max(episodes, sums.episodes);
    for (const double sum : {sums.success, sums.spl}) {
      row.cells.push_back(sums.episodes == 0 ? "" : fmt::format("{:.2f}", sum / sums.episodes));
    }
  }
  row.remark = Counted(static_cast<std::size_t>(episodes), "episode");
  return row;
}

}  // namespace

std::optional<ResultsTable> SceneTable(std::span<const EpisodeResult> results,
                                       std::span<const AgentRow> agents) {
  std::vector<std::string> scenes;
  for (const EpisodeResult& result : results) scenes.push_back(result.key.scene);
  const std::map<std::string, std::string> called = SceneNames(scenes);
  const std::optional<std::string> condition = FirstCondition(results);
  if (called.size() < 2 || called.size() > kMostScenes || !condition) return std::nullopt;
  const Places places = Gather(results, *condition);
  const std::vector<std::string> names = AgentsIn(places, agents);
  ResultsTable table;
  table.caption = "Success and SPL by scene.";
  table.titles = "Scene";
  for (const std::string& name : names) {
    table.groups.push_back({AgentTitle(name, agents), {"Succ", "SPL"}});
  }
  for (const auto& [place, cells] : places) {
    table.rows.push_back(RowOf(place.first, called.at(place.second), cells, names));
  }
  return table;
}

}  // namespace bulletnav::bench
