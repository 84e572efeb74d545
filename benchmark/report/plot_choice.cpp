// SPDX-License-Identifier: MIT
#include "benchmark/report/plot_choice.h"

#include <algorithm>
#include <map>
#include <system_error>
#include <tuple>
#include <utility>

#include <fmt/core.h>

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

double MeanSoftSpl(const EpisodeTrajectory& trajectory) {
  double sum = 0.0;
  for (const GoalMetrics& goal : trajectory.result.goals) sum += goal.soft_spl;
  return sum / static_cast<double>(trajectory.result.goals.size());
}

/// A row of a table: an agent in a setting, under a condition, with a seed.
std::string RowOf(const ChosenTrajectory& one) {
  const ResultKey& key = one.trajectory.result.key;
  return fmt::format("{} {} {} {}", key.agent, key.setting, key.condition, key.seed);
}

/// The worst first. Of equally bad ones each row has one in turn, and goes through the scenes in
/// turn, beginning with another one than the row before it.
class WorstFirst {
 public:
  explicit WorstFirst(const std::vector<ChosenTrajectory>& all) {
    for (const ChosenTrajectory& one : all) {
      rows_.try_emplace(RowOf(one));
      scenes_.try_emplace(one.trajectory.result.key.scene);
    }
    Number(&rows_);
    Number(&scenes_);
  }

  void Sort(std::vector<ChosenTrajectory>* all) const {
    std::map<std::tuple<double, std::size_t, std::size_t>, std::size_t> in_scene;
    std::vector<std::pair<Rank, std::size_t>> ranks;
    for (std::size_t i = 0; i < all->size(); ++i) {
      const ChosenTrajectory& one = (*all)[i];
      const std::size_t row = rows_.at(RowOf(one));
      const std::size_t scene = scenes_.at(one.trajectory.result.key.scene);
      const std::size_t turn = (scene + scenes_.size() - row % scenes_.size()) % scenes_.size();
      const double score = MeanSoftSpl(one.trajectory);
      ranks.push_back({{score, in_scene[{score, row, scene}]++, turn, row}, i});
    }
    TakeTurns(&ranks);
    std::vector<ChosenTrajectory> sorted;
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

std::vector<ChosenTrajectory> ReadTrajectories(const fs::path& run) {
  const fs::path folder = run / "trajectories";
  std::error_code unreadable;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder, unreadable)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<ChosenTrajectory> all;
  all.reserve(files.size());
  for (const fs::path& file : files) {
    all.push_back({fs::relative(file, folder).replace_extension(), ReadTrajectory(file)});
  }
  return all;
}

std::vector<ChosenTrajectory> Choose(std::vector<ChosenTrajectory> all, const PlotChoice& choice) {
  std::erase_if(all, [&](const ChosenTrajectory& one) {
    const ResultKey& key = one.trajectory.result.key;
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
