// SPDX-License-Identifier: MIT
#include "benchmark/runs/comparison.h"

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <fmt/core.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kBootstrapSeed = 0;
constexpr double kSameStart = 1e-3;  // metres of way; versions may differ in the last digits

/// Values of the paired episodes of one row, in the order of their keys.
struct Samples {
  std::vector<double> success_a;
  std::vector<double> success_b;
  std::vector<double> spl_a;
  std::vector<double> spl_b;
};

struct RowKey {
  std::string agent_a;
  std::string setting_a;
  std::string condition_a;
  std::size_t difficulty = 0;  // place in kDifficulties, or after them: overall

  auto Order() const { return std::tie(agent_a, setting_a, condition_a, difficulty); }
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

using ResultMap = std::map<ResultKey, const EpisodeResult*>;

/// The results that the pairing asks for.
ResultMap ByKey(const std::vector<EpisodeResult>& results, const Pairing& pairing,
                std::string std::pair<std::string, std::string>::*side) {
  const auto is_asked = [&](const Pairing::Names& names, const std::string& name) {
    return !names || *names.*side == name;
  };
  ResultMap by_key;
  for (const EpisodeResult& result : results) {
    if (is_asked(pairing.agents, result.key.agent) &&
        is_asked(pairing.settings, result.key.setting) &&
        is_asked(pairing.conditions, result.key.condition)) {
      by_key[result.key] = &result;
    }
  }
  return by_key;
}

/// "nts (rgbd, noise), random (rgbd, noise)".
std::string ContentsOf(const std::vector<EpisodeResult>& results) {
  std::set<std::string> names;
  for (const EpisodeResult& result : results) {
    const ResultKey& key = result.key;
    names.insert(fmt::format("{} ({}, {})", key.agent, key.setting, key.condition));
  }
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "nothing" : list;
}

/// The key that a result of the first run has its partner under.
ResultKey Partner(ResultKey key, const Pairing& pairing) {
  if (pairing.agents) key.agent = pairing.agents->second;
  if (pairing.settings) key.setting = pairing.settings->second;
  if (pairing.conditions) key.condition = pairing.conditions->second;
  return key;
}

void RequireSameEpisode(const EpisodeResult& a, const EpisodeResult& b) {
  const double start_a = a.goals.front().start_distance;
  const double start_b = b.goals.front().start_distance;
  if (a.goals.size() == b.goals.size() && std::abs(start_a - start_b) <= kSameStart) return;
  throw sim::Error(fmt::format(
      "the runs are of different episodes: '{}' in {} has {} goals in one, the first {:.3f} m "
      "away, and {} in the other, the first {:.3f} m away; play both from one file of episodes",
      a.key.episode, a.key.scene, a.goals.size(), start_a, b.goals.size(), start_b));
}

/// "a -> b", or one name if both are the same.
std::string Between(const std::string& a, const std::string& b) {
  return a == b ? a : a + " -> " + b;
}

void Add(const EpisodeResult& a, const EpisodeResult& b, Samples* samples) {
  samples->success_a.push_back(Success(a));
  samples->success_b.push_back(Success(b));
  samples->spl_a.push_back(Spl(a));
  samples->spl_b.push_back(Spl(b));
}

ComparisonRow MakeRow(const RowKey& key, const Samples& samples, const Pairing& pairing) {
  const ResultKey partner =
      Partner({key.agent_a, key.setting_a, key.condition_a, 0, "", ""}, pairing);
  ComparisonRow row;
  row.agent_a = key.agent_a;
  row.agent_b = partner.agent;
  row.setting = Between(key.setting_a, partner.setting);
  row.condition = Between(key.condition_a, partner.condition);
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
                       const Pairing& pairing) {
  using Sides = std::pair<std::string, std::string>;
  const ResultMap all_a = ByKey(a, pairing, &Sides::first);
  const ResultMap all_b = ByKey(b, pairing, &Sides::second);
  std::map<RowKey, Samples> groups;
  int pairs = 0;
  for (const auto& [key_a, result_a] : all_a) {
    const auto found = all_b.find(Partner(key_a, pairing));
    if (found == all_b.end()) continue;
    RequireSameEpisode(*result_a, *found->second);
    ++pairs;
    RowKey row = {key_a.agent, key_a.setting, key_a.condition, kDifficulties.size()};
    Add(*result_a, *found->second, &groups[row]);
    if (!result_a->difficulty) continue;
    row.difficulty = static_cast<std::size_t>(*result_a->difficulty);
    Add(*result_a, *found->second, &groups[row]);
  }
  if (pairs == 0) {
    throw sim::Error(fmt::format(
        "the runs share no results: one has {}; the other {}; name one of each with --agents, "
        "--settings or --conditions, or compare runs of the same episodes",
        ContentsOf(a), ContentsOf(b)));
  }
  Comparison comparison;
  for (const auto& [key, samples] : groups) {
    comparison.rows.push_back(MakeRow(key, samples, pairing));
  }
  comparison.only_a = static_cast<int>(all_a.size()) - pairs;
  comparison.only_b = static_cast<int>(all_b.size()) - pairs;
  return comparison;
}

std::string ToText(const Comparison& comparison) {
  const auto difference = [](const PairedDifference& d) {
    const std::string p = d.p_value < 0.001 ? "p < 0.001" : fmt::format("p {:.3f}", d.p_value);
    return fmt::format("{:+.3f} [{:+.3f}, {:+.3f}] {}", d.mean, d.interval.low, d.interval.high, p);
  };
  std::string text;
  std::string last;
  for (const ComparisonRow& row : comparison.rows) {
    const std::string head =
        fmt::format("{}, {}, {}", Between(row.agent_a, row.agent_b), row.setting, row.condition);
    if (head != last) text += head + "\n";
    last = head;
    text += fmt::format("  {:<8} {:5} pairs  success {:.2f} -> {:.2f}: {}\n", row.difficulty,
                        row.success.pairs, row.success_a, row.success_b, difference(row.success));
    text += fmt::format("  {:<8} {:5}        SPL     {:.2f} -> {:.2f}: {}\n", "", "", row.spl_a,
                        row.spl_b, difference(row.spl));
  }
  text +=
      "differences: second less first, with the 95% interval of their mean, and p of the sign "
      "test, which asks how many pairs got better, not by how much\n";
  if (comparison.only_a + comparison.only_b > 0) {
    text +=
        fmt::format("left out for want of a partner: {} results of the first, {} of the second\n",
                    comparison.only_a, comparison.only_b);
  }
  return text;
}

}  // namespace bulletnav::bench
