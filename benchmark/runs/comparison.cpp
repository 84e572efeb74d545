// SPDX-License-Identifier: MIT
#include "benchmark/runs/comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kBootstrapSeed = 0;
constexpr double kSameStart = 1e-3;  // metres of way; versions may differ in the last digits

/// Paired episodes of one row, in the order of their keys.
using Pairs = std::vector<std::pair<const EpisodeResult*, const EpisodeResult*>>;

struct RowKey {
  std::string agent_a;
  std::string setting_a;
  std::string condition_a;
  std::size_t difficulty = 0;  // place in kDifficulties, or after them: overall

  auto Order() const { return std::tie(agent_a, setting_a, condition_a, difficulty); }
  bool operator<(const RowKey& other) const { return Order() < other.Order(); }
};

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
  const double start_a = a.goals.front().Value("start_distance");
  const double start_b = b.goals.front().Value("start_distance");
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

ComparedMeasure Compared(const Measure& measure, const Pairs& pairs) {
  std::vector<double> a;
  std::vector<double> b;
  for (const auto& [result_a, result_b] : pairs) {
    const auto value_a = EpisodeValue(measure, result_a->goals);
    const auto value_b = EpisodeValue(measure, result_b->goals);
    if (!value_a || !value_b) continue;
    a.push_back(*value_a);
    b.push_back(*value_b);
  }
  return {measure, Mean(a), Mean(b), ComparePairs(a, b, kBootstrapSeed)};
}

constexpr const char* kLegend =
    "differences: second less first, with the 95% interval of their mean, and p of the sign test, "
    "which asks how many pairs got better, not by how much";

std::string Chance(const PairedDifference& difference) {
  return difference.p_value < 0.001 ? "p < 0.001" : fmt::format("p {:.3f}", difference.p_value);
}

std::string DifferenceText(const PairedDifference& d) {
  return fmt::format("{:+.3f} [{:+.3f}, {:+.3f}] {}", d.mean, d.interval.low, d.interval.high,
                     Chance(d));
}

/// Of one row; measures that it lacks are empty cells.
std::string MarkdownLine(const ComparisonRow& row) {
  const int pairs = row.measures.empty() ? 0 : row.measures.front().difference.pairs;
  std::string line =
      fmt::format("| {} | {}, {} | {}, {} pairs |", Between(row.agent_a, row.agent_b), row.setting,
                  row.condition, row.difficulty, pairs);
  for (const Measure& measure : MainMeasures()) {
    const auto found = std::find_if(row.measures.begin(), row.measures.end(),
                                    [&](const ComparedMeasure& compared) {
                                      return compared.measure.name == measure.name;
                                    });
    line += found == row.measures.end() ? "  |  |"
                                        : fmt::format(" {:.2f} to {:.2f} | {} |", found->a,
                                                      found->b, DifferenceText(found->difference));
  }
  return line + "\n";
}

/// A line, or nothing if all had one.
std::string LeftOut(const Comparison& comparison) {
  if (comparison.only_a + comparison.only_b == 0) return "";
  return fmt::format("left out for want of a partner: {} results of the first, {} of the second\n",
                     comparison.only_a, comparison.only_b);
}

ComparisonRow MakeRow(const RowKey& key, const Pairs& pairs, const Pairing& pairing) {
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
  for (const Measure& measure : MainMeasures()) {
    row.measures.push_back(Compared(measure, pairs));
    if (row.measures.back().difference.pairs == 0) row.measures.pop_back();
  }
  return row;
}

using Sides = std::pair<std::string, std::string>;

/// Without rows if there is nothing to pair.
Comparison Compare(const std::vector<EpisodeResult>& a, const std::vector<EpisodeResult>& b,
                   const Pairing& pairing) {
  const ResultMap all_a = ByKey(a, pairing, &Sides::first);
  const ResultMap all_b = ByKey(b, pairing, &Sides::second);
  std::map<RowKey, Pairs> groups;
  int pairs = 0;
  for (const auto& [key_a, result_a] : all_a) {
    const auto found = all_b.find(Partner(key_a, pairing));
    if (found == all_b.end()) continue;
    RequireSameEpisode(*result_a, *found->second);
    ++pairs;
    RowKey row = {key_a.agent, key_a.setting, key_a.condition, kDifficulties.size()};
    groups[row].emplace_back(result_a, found->second);
    if (!result_a->difficulty) continue;
    row.difficulty = static_cast<std::size_t>(*result_a->difficulty);
    groups[row].emplace_back(result_a, found->second);
  }
  Comparison comparison;
  for (const auto& [key, row_pairs] : groups) {
    comparison.rows.push_back(MakeRow(key, row_pairs, pairing));
  }
  comparison.only_a = static_cast<int>(all_a.size()) - pairs;
  comparison.only_b = static_cast<int>(all_b.size()) - pairs;
  return comparison;
}

[[noreturn]] void ThrowNothingShared(const std::vector<EpisodeResult>& a,
                                     const std::vector<EpisodeResult>& b) {
  throw sim::Error(fmt::format(
      "the runs share no results: one has {}; the other {}; name one of each with --agents, "
      "--settings or --conditions, or compare runs of the same episodes",
      ContentsOf(a), ContentsOf(b)));
}

}  // namespace

Comparison CompareRuns(const std::vector<EpisodeResult>& a, const std::vector<EpisodeResult>& b,
                       const Pairing& pairing) {
  Comparison comparison = Compare(a, b, pairing);
  if (comparison.rows.empty()) ThrowNothingShared(a, b);
  return comparison;
}

Comparison CompareWithAll(const std::vector<EpisodeResult>& a, const std::vector<EpisodeResult>& b,
                          const std::string& agent, const Pairing& pairing) {
  std::set<std::string> others;
  for (const EpisodeResult& result : b) others.insert(result.key.agent);
  others.erase(agent);
  Comparison all;
  for (const std::string& other : others) {
    Pairing pair = pairing;
    pair.agents = {agent, other};
    const Comparison one = Compare(a, b, pair);
    all.rows.insert(all.rows.end(), one.rows.begin(), one.rows.end());
  }
  if (!all.rows.empty()) return all;
  std::set<std::string> known;
  for (const EpisodeResult& result : a) known.insert(result.key.agent);
  if (known.contains(agent)) ThrowNothingShared(a, b);
  throw sim::Error(
      fmt::format("the first run has no agent '{}'; it has {}", agent, fmt::join(known, ", ")));
}

std::string ToText(const Comparison& comparison) {
  std::string text;
  std::string last;
  for (const ComparisonRow& row : comparison.rows) {
    const std::string head =
        fmt::format("{}, {}, {}", Between(row.agent_a, row.agent_b), row.setting, row.condition);
    if (head != last) text += head + "\n";
    last = head;
    int pairs = 0;  // said where it changes
    for (const ComparedMeasure& m : row.measures) {
      const bool is_first = &m == &row.measures.front();
      const std::string count =
          m.difference.pairs == pairs ? "" : fmt::format("{:5} pairs", m.difference.pairs);
      pairs = m.difference.pairs;
      text += fmt::format("  {:<8} {:<11}  {:<7} {:.2f} -> {:.2f}: {}\n",
                          is_first ? row.difficulty : "", count, m.measure.label, m.a, m.b,
                          DifferenceText(m.difference));
    }
  }
  return text + kLegend + "\n" + LeftOut(comparison);
}

std::string ToMarkdown(const Comparison& comparison) {
  std::string head = "| | | |";
  std::string rule = "| --- | --- | --- |";
  for (const Measure& measure : MainMeasures()) {
    head += fmt::format(" {} | difference |", measure.label);
    rule += " ---: | ---: |";
  }
  std::string text = head + "\n" + rule + "\n";
  for (const ComparisonRow& row : comparison.rows) {
    text += MarkdownLine(row);
  }
  return text + "\n" + kLegend + "\n" + LeftOut(comparison);
}

}  // namespace bulletnav::bench
