// SPDX-License-Identifier: MIT
#include "benchmark/evaluation/comparison.h"

#include <map>
#include <set>
#include <tuple>

#include <fmt/core.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kBootstrapSeed = 0;

using Agents = std::optional<std::pair<std::string, std::string>>;

/// Values of the paired episodes of one row, in the order of their keys.
struct Samples {
  std::vector<double> success_a;
  std::vector<double> success_b;
  std::vector<double> spl_a;
  std::vector<double> spl_b;
};

struct RowKey {
  std::string agent_a;
  std::string setting;
  std::string condition;
  std::size_t difficulty = 0;  // place in kDifficulties, or after them: overall

  auto Order() const { return std::tie(agent_a, setting, condition, difficulty); }
  bool operator<(const RowKey& other) const { return Order() < other.Order(); }
};

double Success(const EpisodeResult& result) {
  std::vector<double> values;
  for (const GoalMetrics& goal : result.goals) values.push_back(goal.success ? 1.0 : 0.0);
  return Mean(values);
}

double Spl(const EpisodeResult& result) {
  std::vector<double> values;
  for (const GoalMetrics& goal : result.goals) values.push_back(goal.spl);
  return Mean(values);
}

std::map<ResultKey, const EpisodeResult*> ByKey(const std::vector<EpisodeResult>& results,
                                                const std::string& agent) {
  std::map<ResultKey, const EpisodeResult*> by_key;
  for (const EpisodeResult& result : results) {
    if (agent.empty() || result.key.agent == agent) by_key[result.key] = &result;
  }
  return by_key;
}

std::string AgentsOf(const std::vector<EpisodeResult>& results) {
  std::set<std::string> names;
  for (const EpisodeResult& result : results) names.insert(result.key.agent);
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "nothing" : list;
}

void Add(const EpisodeResult& a, const EpisodeResult& b, Samples* samples) {
  samples->success_a.push_back(Success(a));
  samples->success_b.push_back(Success(b));
  samples->spl_a.push_back(Spl(a));
  samples->spl_b.push_back(Spl(b));
}

ComparisonRow MakeRow(const RowKey& key, const Samples& samples, const Agents& agents) {
  ComparisonRow row;
  row.agent_a = key.agent_a;
  row.agent_b = agents ? agents->second : key.agent_a;
  row.setting = key.setting;
  row.condition = key.condition;
  row.difficulty = key.difficulty < kDifficulties.size()
                       ? std::string(DifficultyName(kDifficulties[key.difficulty]))
                       : "overall";
  row.success_a = Mean(samples.success_a);
  row.success_b = Mean(samples.success_b);
  row.spl_a = Mean(samples.spl_a);
  row.spl_b = Mean(samples.spl_b);
  row.success = ComparePairs(samples.success_a, samples.success_b, kBootstrapSeed);
  row.spl = ComparePairs(samples.spl_a, samples.spl_b, kBootstrapSeed);
  return row;
}

}  // namespace

Comparison CompareRuns(const std::vector<EpisodeResult>& a, const std::vector<EpisodeResult>& b,
                       const Agents& agents) {
  const auto all_a = ByKey(a, agents ? agents->first : "");
  const auto all_b = ByKey(b, agents ? agents->second : "");
  std::map<RowKey, Samples> groups;
  int pairs = 0;
  for (const auto& [key_a, result_a] : all_a) {
    ResultKey key_b = key_a;
    if (agents) key_b.agent = agents->second;
    const auto found = all_b.find(key_b);
    if (found == all_b.end()) continue;
    ++pairs;
    RowKey row = {key_a.agent, key_a.setting, key_a.condition, kDifficulties.size()};
    Add(*result_a, *found->second, &groups[row]);
    if (!result_a->difficulty) continue;
    row.difficulty = static_cast<std::size_t>(*result_a->difficulty);
    Add(*result_a, *found->second, &groups[row]);
  }
  if (pairs == 0) {
    throw sim::Error(fmt::format(
        "the runs share no results: one has {}, the other {}; name an agent of each with --agents, "
        "or compare runs of the same episodes",
        AgentsOf(a), AgentsOf(b)));
  }
  Comparison comparison;
  for (const auto& [key, samples] : groups) {
    comparison.rows.push_back(MakeRow(key, samples, agents));
  }
  comparison.only_a = static_cast<int>(all_a.size()) - pairs;
  comparison.only_b = static_cast<int>(all_b.size()) - pairs;
  return comparison;
}

std::string ToText(const Comparison& comparison) {
  const auto difference = [](const PairedDifference& d) {
    return fmt::format("{:+.3f} [{:+.3f}, {:+.3f}] p {:.3f}", d.mean, d.interval.low,
                       d.interval.high, d.p_value);
  };
  std::string text;
  std::string last;
  for (const ComparisonRow& row : comparison.rows) {
    const std::string agents =
        row.agent_a == row.agent_b ? row.agent_a : row.agent_a + " -> " + row.agent_b;
    const std::string head = fmt::format("{}, {}, {}", agents, row.setting, row.condition);
    if (head != last) text += head + "\n";
    last = head;
    text += fmt::format("  {:<8} {:5} pairs  success {:.2f} -> {:.2f}: {}\n", row.difficulty,
                        row.success.pairs, row.success_a, row.success_b, difference(row.success));
    text += fmt::format("  {:<8} {:5}        SPL     {:.2f} -> {:.2f}: {}\n", "", "", row.spl_a,
                        row.spl_b, difference(row.spl));
  }
  text += "differences: second less first, with their 95% interval and p of the sign test\n";
  if (comparison.only_a + comparison.only_b > 0) {
    text +=
        fmt::format("left out for want of a partner: {} results of the first, {} of the second\n",
                    comparison.only_a, comparison.only_b);
  }
  return text;
}

}  // namespace bulletnav::bench
