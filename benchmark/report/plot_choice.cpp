// SPDX-License-Identifier: MIT
#include "benchmark/report/plot_choice.h"

#include <algorithm>
#include <map>
#include <system_error>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "benchmark/play/trajectory.h"
#include "benchmark/runs/result_store.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// A row of a table: an agent in a setting, under a condition, with a seed.
std::string RowOf(const EpisodeResult& one) {
  const ResultKey& key = one.key;
  return fmt::format("{} {} {} {}", key.agent, key.setting, key.condition, key.seed);
}

/// The worst first. Of equally bad ones each row has one in turn, and goes through the scenes in
/// turn, beginning with another one than the row before it.
class WorstFirst {
 public:
  explicit WorstFirst(const std::vector<EpisodeResult>& all) {
    for (const EpisodeResult& one : all) {
      rows_.try_emplace(RowOf(one));
      scenes_.try_emplace(one.key.scene);
    }
    Number(&rows_);
    Number(&scenes_);
  }

  void Sort(std::vector<EpisodeResult>* all) const {
    const Measure& soft_spl = FindMeasure("soft_spl");
    std::map<std::tuple<double, std::size_t, std::size_t>, std::size_t> in_scene;
    std::vector<std::pair<Rank, std::size_t>> ranks;
    for (std::size_t i = 0; i < all->size(); ++i) {
      const EpisodeResult& one = (*all)[i];
      const std::size_t row = rows_.at(RowOf(one));
      const std::size_t scene = scenes_.at(one.key.scene);
      const std::size_t turn = (scene + scenes_.size() - row % scenes_.size()) % scenes_.size();
      const double score = EpisodeValue(soft_spl, one.goals).value_or(0.0);
      ranks.push_back({{score, in_scene[{score, row, scene}]++, turn, row}, i});
    }
    TakeTurns(&ranks);
    std::vector<EpisodeResult> sorted;
    sorted.reserve(ranks.size());
    for (const auto& [rank, i] : ranks) sorted.push_back(std::move((*all)[i]));
    *all = std::move(sorted);
  }

 private:
  /// SoftSPL, how many of the same row and scene come before, turn of the scene, row.
  using Rank = std::tuple<double, std::size_t, std::size_t, std::size_t>;

  static void Number(std::map<std::string, std::size_t>* names) {
    std::size_t number = 0;
    for (auto& [name, place] : *names) place = number++;
  }

  /// In each row equally bad episodes are ranked by round over the scenes; now by their place in
  /// that order, so that a row with few scenes does not wait for the others.
  static void TakeTurns(std::vector<std::pair<Rank, std::size_t>>* ranks) {
    std::sort(ranks->begin(), ranks->end());
    std::map<std::pair<double, std::size_t>, std::size_t> in_row;
    for (auto& [rank, i] : *ranks) {
      const auto [score, round, turn, row] = rank;
      rank = {score, in_row[{score, row}]++, 0, row};
    }
    std::sort(ranks->begin(), ranks->end());
  }

  std::map<std::string, std::size_t> rows_;    // numbers by name
  std::map<std::string, std::size_t> scenes_;  // numbers by name
};

}  // namespace

std::vector<EpisodeResult> ResultsWithTrajectory(const fs::path& run) {
  std::map<fs::path, EpisodeResult> by_file;
  for (EpisodeResult& result : ReadResults(run)) {
    const fs::path file = TrajectoryPath(run, result.key);
    std::error_code unreadable;
    if (fs::exists(file, unreadable)) by_file.emplace(file, std::move(result));
  }
  std::vector<EpisodeResult> results;
  results.reserve(by_file.size());
  for (auto& [file, result] : by_file) results.push_back(std::move(result));
  return results;
}

std::vector<EpisodeResult> Choose(std::vector<EpisodeResult> all, const PlotChoice& choice) {
  std::erase_if(all, [&](const EpisodeResult& one) {
    const ResultKey& key = one.key;
    return (!choice.episode.empty() && key.episode != choice.episode) ||
           (!choice.agent.empty() && key.agent != choice.agent);
  });
  if (choice.worst > 0) WorstFirst(all).Sort(&all);
  const bool is_limited = !choice.all && choice.episode.empty();
  const auto most = static_cast<std::size_t>(choice.worst > 0 ? choice.worst : kFirstPlots);
  if (is_limited && all.size() > most) all.resize(most);
  return all;
}

}  // namespace bulletnav::bench
