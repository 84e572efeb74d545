// SPDX-License-Identifier: MIT
#include "benchmark/report/plot_choice.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

double MeanSoftSpl(const EpisodeTrajectory& trajectory) {
  double sum = 0.0;
  for (const GoalMetrics& goal : trajectory.result.goals) sum += goal.soft_spl;
  return sum / static_cast<double>(trajectory.result.goals.size());
}

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
  if (choice.worst > 0) {
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return MeanSoftSpl(a.trajectory) < MeanSoftSpl(b.trajectory);
    });
  }
  const bool is_limited = !choice.all && choice.episode.empty();
  const auto most = static_cast<std::size_t>(choice.worst > 0 ? choice.worst : kFirstPlots);
  if (is_limited && all.size() > most) all.resize(most);
  return all;
}

}  // namespace bulletnav::bench
