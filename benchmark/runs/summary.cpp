// SPDX-License-Identifier: MIT
#include "benchmark/runs/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/core.h>

#include "benchmark/base/json_cursor.h"
#include "benchmark/runs/published.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kBootstrapSeed = 0;

/// The numbers of one episode, as they enter a row's means.
struct Sample {
  double success = 0.0;
  double success_euclidean = 0.0;
  double spl = 0.0;
  double soft_spl = 0.0;
  double distance_to_goal = 0.0;
  double steps = 0.0;
  double collisions = 0.0;
  bool failed = false;
  bool single = true;
};

/// Of the first `count` goals of an episode.
Sample SampleOf(const EpisodeResult& result, std::size_t count) {
  Sample sample;
  const auto n = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const GoalMetrics& goal = result.goals[i];
    sample.success += goal.success ? 1.0 : 0.0;
    sample.success_euclidean += goal.success_euclidean ? 1.0 : 0.0;
    sample.spl += goal.spl;
    sample.soft_spl += goal.soft_spl;
    sample.distance_to_goal +=
        std::isfinite(goal.distance_to_goal) ? goal.distance_to_goal : goal.euclidean_distance;
    sample.steps += goal.steps;
    sample.collisions += goal.collisions;
  }
  for (double* sum : {&sample.success, &sample.success_euclidean, &sample.spl, &sample.soft_spl,
                      &sample.distance_to_goal}) {
    *sum /= n;  // after summing: ten goals of ten are 1
  }
  sample.failed = !result.failure.empty();
  sample.single = count == 1;
  return sample;
}

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

constexpr std::array<const char*, 3> kConditions = {"noise", "no_stop", "no_noise"};
constexpr std::size_t kOverall = 3;
constexpr std::size_t kFirstGoals = 4;  // and one further on a goal

std::size_t ConditionPlace(const std::string& name) {
  return static_cast<std::size_t>(std::find(kConditions.begin(), kConditions.end(), name) -
                                  kConditions.begin());
}

std::string DifficultyOfPlace(std::size_t place) {
  if (place < kOverall) return std::string(DifficultyName(kDifficulties[place]));
  return place == kOverall ? "overall" : fmt::format("goals_{}", place - kFirstGoals + 1);
}

std::vector<double> Column(const std::vector<Sample>& samples, double Sample::*member) {
  std::vector<double> values;
  values.reserve(samples.size());
  for (const Sample& sample : samples) values.push_back(sample.*member);
  return values;
}

bool IsSingle(const Sample& sample) {
  return sample.single;
}

Interval SuccessInterval(const std::vector<Sample>& samples) {
  const std::vector<double> success = Column(samples, &Sample::success);
  const bool single = std::all_of(samples.begin(), samples.end(), IsSingle);
  if (!single) return BootstrapInterval(success, kBootstrapSeed);
  const auto successes = std::count(success.begin(), success.end(), 1.0);
  return WilsonInterval(static_cast<int>(successes), static_cast<int>(success.size()));
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
  const std::vector<double> spl = Column(samples, &Sample::spl);
  row.success = Mean(Column(samples, &Sample::success));
  row.success_ci = SuccessInterval(samples);
  row.success_euclidean = Mean(Column(samples, &Sample::success_euclidean));
  row.spl = Mean(spl);
  row.spl_ci = BootstrapInterval(spl, kBootstrapSeed);
  row.soft_spl = Mean(Column(samples, &Sample::soft_spl));
  row.distance_to_goal_mean = Mean(Column(samples, &Sample::distance_to_goal));
  row.steps_mean = Mean(Column(samples, &Sample::steps));
  row.collisions_mean = Mean(Column(samples, &Sample::collisions));
  if (!std::all_of(samples.begin(), samples.end(), IsSingle)) return row;
  const PublishedFigure paper =
      FindPublished(row.agent, row.setting, row.condition, row.difficulty);
  row.paper_success = paper.success;
  row.paper_spl = paper.spl;
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
    groups[key].push_back(SampleOf(result, result.goals.size()));
    if (result.difficulty) {
      key.difficulty = static_cast<std::size_t>(*result.difficulty);
      groups[key].push_back(SampleOf(result, result.goals.size()));
    }
    for (std::size_t count = 1; result.goals.size() > 1 && count <= result.goals.size(); ++count) {
      key.difficulty = kFirstGoals + count - 1;
      groups[key].push_back(SampleOf(result, count));
    }
  }
  return groups;
}

template <class T>
Json OrNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json ToJson(const SummaryRow& row) {
  return {{"agent", row.agent},
          {"setting", row.setting},
          {"condition", row.condition},
          {"difficulty", row.difficulty},
          {"episodes", row.episodes},
          {"success", row.success},
          {"success_ci", {row.success_ci.low, row.success_ci.high}},
          {"success_euclidean", row.success_euclidean},
          {"spl", row.spl},
          {"spl_ci", {row.spl_ci.low, row.spl_ci.high}},
          {"soft_spl", row.soft_spl},
          {"steps_mean", row.steps_mean},
          {"collisions_mean", row.collisions_mean},
          {"frames_trained", OrNull(row.frames_trained)},
          {"paper_success", OrNull(row.paper_success)},
          {"paper_spl", OrNull(row.paper_spl)},
          {"distance_to_goal_mean", row.distance_to_goal_mean},
          {"note", row.note}};
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
