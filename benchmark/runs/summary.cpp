// SPDX-License-Identifier: MIT
#include "benchmark/runs/summary.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/core.h>

#include "benchmark/base/json_cursor.h"
#include "benchmark/play/condition.h"
#include "benchmark/runs/published.h"
#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kBootstrapSeed = 0;

/// An episode, or the first goals of one.
struct Sample {
  std::span<const GoalMetrics> goals;
  bool failed = false;
};

/// Where a row stands among the others.
struct RowKey {
  std::size_t agent = 0;
  std::string agent_name;
  std::string setting;
  std::size_t condition = 0;
  std::string condition_name;
  std::size_t difficulty = 0;

  auto Order() const {
    return std::tie(agent, agent_name, setting, condition, condition_name, difficulty);
  }
  bool operator<(const RowKey& other) const { return Order() < other.Order(); }
};

constexpr std::size_t kOverall = kDifficulties.size();
constexpr std::size_t kFirstGoals = kOverall + 1;  // and one further on a goal

std::size_t ConditionPlace(const std::string& name) {
  const auto& names = sim::EnumNames<Condition>::kNames;
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& known) {
    return known.first == name;
  });
  return static_cast<std::size_t>(found - names.begin());
}

std::string DifficultyOfPlace(std::size_t place) {
  if (place < kOverall) return std::string(DifficultyName(kDifficulties[place]));
  return place == kOverall ? "overall" : fmt::format("goals_{}", place - kFirstGoals + 1);
}

bool HasAll(const Measure& measure, const Sample& sample) {
  return std::all_of(sample.goals.begin(), sample.goals.end(), [&](const GoalMetrics& goal) {
    return goal.Find(measure.name).has_value();
  });
}

bool AreSingle(const std::vector<Sample>& samples) {
  return std::all_of(samples.begin(), samples.end(), [](const Sample& sample) {
    return sample.goals.size() == 1;
  });
}

Average AverageOf(const Measure& measure, const std::vector<Sample>& samples) {
  std::vector<double> values;
  for (const Sample& sample : samples) {
    if (!HasAll(measure, sample)) return {};
    if (const auto value = EpisodeValue(measure, sample.goals)) values.push_back(*value);
  }
  if (values.empty()) return {};
  Average average;
  average.mean = Mean(values);
  if (!measure.is_main()) return average;
  const bool is_share = measure.kind == MeasureKind::kYesNo && AreSingle(samples);
  average.interval = is_share ? ShareInterval(values) : BootstrapInterval(values, kBootstrapSeed);
  return average;
}

SummaryRow MakeRow(const RowKey& key, const std::vector<Sample>& samples) {
  SummaryRow row;
  row.agent = key.agent_name;
  row.setting = key.setting;
  row.condition = key.condition_name;
  row.difficulty = DifficultyOfPlace(key.difficulty);
  row.episodes = static_cast<int>(samples.size());
  row.failures =
      static_cast<int>(std::count_if(samples.begin(), samples.end(), [](const Sample& s) {
        return s.failed;
      }));
  for (const Measure& measure : AllMeasures()) {
    if (measure.column.empty()) continue;
    Average& average = row.averages[std::string(measure.name)];
    average = AverageOf(measure, samples);
    if (!AreSingle(samples)) continue;
    average.paper =
        FindPublished(measure.name, row.agent, row.setting, row.condition, row.difficulty);
  }
  return row;
}

std::map<RowKey, std::vector<Sample>> Group(const std::vector<EpisodeResult>& results,
                                            std::span<const AgentRow> agents) {
  std::map<RowKey, std::vector<Sample>> groups;
  for (const EpisodeResult& result : results) {
    const ResultKey& from = result.key;
    const auto agent = std::find_if(agents.begin(), agents.end(), [&](const AgentRow& row) {
      return row.agent == from.agent;
    });
    RowKey key = {static_cast<std::size_t>(agent - agents.begin()),
                  from.agent,
                  from.setting,
                  ConditionPlace(from.condition),
                  from.condition,
                  kOverall};
    const bool failed = !result.failure.empty();
    groups[key].push_back({result.goals, failed});
    if (result.difficulty) {
      key.difficulty = static_cast<std::size_t>(*result.difficulty);
      groups[key].push_back({result.goals, failed});
    }
    for (std::size_t count = 1; result.goals.size() > 1 && count <= result.goals.size(); ++count) {
      key.difficulty = kFirstGoals + count - 1;
      groups[key].push_back({std::span(result.goals).first(count), failed});
    }
  }
  return groups;
}

template <class T>
Json OrNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

void WriteAverages(const SummaryRow& row, ColumnPlace place, Json* json) {
  for (const Measure& measure : AllMeasures()) {
    if (measure.column.empty() || measure.column_place != place) continue;
    const std::string column(measure.column);
    BULLETNAV_CHECK(!json->contains(column));  // two columns of one name
    const Average average = row.Of(measure.name);
    (*json)[column] = OrNull(average.mean);
    if (!measure.is_main()) continue;
    const std::optional<Interval>& interval = average.interval;
    (*json)[column + "_ci"] = interval ? Json{interval->low, interval->high} : Json{{}, {}};
  }
}

Json ToJson(const SummaryRow& row) {
  Json json = {{"agent", row.agent},
               {"setting", row.setting},
               {"condition", row.condition},
               {"difficulty", row.difficulty},
               {"episodes", row.episodes}};
  WriteAverages(row, ColumnPlace::kBeforePaper, &json);
  json["frames_trained"] = OrNull(row.frames_trained);
  for (const std::string_view measure : kPublishedMeasures) {
    json["paper_" + std::string(measure)] = OrNull(row.Of(measure).paper);
  }
  WriteAverages(row, ColumnPlace::kAfterPaper, &json);
  json["note"] = row.note;
  return json;
}

/// A text as one CSV field.
std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string CsvValue(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? CsvField(value.get<std::string>()) : value.dump();
}

}  // namespace

Average SummaryRow::Of(std::string_view measure) const {
  const auto found = averages.find(measure);
  return found == averages.end() ? Average() : found->second;
}

std::vector<SummaryRow> Summarize(std::vector<EpisodeResult> results,
                                  std::span<const AgentRow> agents) {
  // Sums of fractions depend on their order in the last digits.
  std::sort(results.begin(), results.end(), [](const EpisodeResult& a, const EpisodeResult& b) {
    return a.key < b.key;
  });
  std::vector<SummaryRow> rows;
  for (const auto& [key, samples] : Group(results, agents)) {
    rows.push_back(MakeRow(key, samples));
    if (key.agent >= agents.size()) continue;
    const AgentRow& agent = agents[key.agent];
    rows.back().note = agent.note;
    const auto frames = agent.frames_trained.find(key.setting);
    if (frames != agent.frames_trained.end()) rows.back().frames_trained = frames->second;
  }
  return rows;
}

std::string SummaryToJson(std::span<const SummaryRow> rows) {
  Json list = Json::array();
  for (const SummaryRow& row : rows) list.push_back(ToJson(row));
  return Json({{"rows", list}}).dump(1) + "\n";
}

std::string SummaryToCsv(std::span<const SummaryRow> rows) {
  std::string names;
  std::string lines;
  const auto add = [](std::string* line, const std::string& field) {
    *line += (line->empty() ? "" : ",") + field;
  };
  const Json shape = ToJson(rows.empty() ? SummaryRow() : rows.front());
  for (const auto& [name, value] : shape.items()) {
    if (value.is_array()) {
      add(&names, name + "_low");
      add(&names, name + "_high");
    } else {
      add(&names, name);
    }
  }
  for (const SummaryRow& row : rows) {
    std::string line;
    const Json json = ToJson(row);
    for (const auto& [name, value] : json.items()) {
      const Json parts = value.is_array() ? value : Json::array({value});
      for (const Json& part : parts) add(&line, CsvValue(part));
    }
    lines += line + "\n";
  }
  return names + "\n" + lines;
}

}  // namespace bulletnav::bench
