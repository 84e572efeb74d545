// SPDX-License-Identifier: MIT
#include "benchmark/episodes/description.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/core.h>

#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

constexpr std::size_t kBarLength = 40;

/// Over all goals: the geodesic distance from the last place, and its ratio to the straight line.
struct Ways {
  std::vector<double> distances;
  std::vector<double> ratios;
};

Ways WaysOf(const std::vector<Episode>& episodes) {
  Ways ways;
  for (const Episode& episode : episodes) {
    Eigen::Vector3d last = episode.start_position;
    for (const EpisodeGoal& goal : episode.goals) {
      const double straight = (goal.position - last).norm();
      ways.distances.push_back(goal.geodesic_distance);
      if (straight > 0.0) ways.ratios.push_back(goal.geodesic_distance / straight);
      last = goal.position;
    }
  }
  return ways;
}

std::string KindOf(const Episode& episode) {
  if (episode.goals.size() > 1) return fmt::format("sequences of {} goals", episode.goals.size());
  return episode.difficulty ? std::string(DifficultyName(*episode.difficulty)) : "other";
}

std::string Mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? "none"
                        : fmt::format("mean {:.2f}", sum / static_cast<double>(values.size()));
}

}  // namespace

std::string TextHistogram(const std::vector<double>& values, double low, double width, int bins) {
  BULLETNAV_CHECK(width > 0.0 && bins > 0);
  std::vector<std::size_t> counts(static_cast<std::size_t>(bins), 0);
  for (const double value : values) {
    const double bin = std::floor((value - low) / width);
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(bins - 1)))];
  }
  const auto filled = [](std::size_t count) {
    return count > 0;
  };
  const auto first = std::find_if(counts.begin(), counts.end(), filled);
  const auto last = std::find_if(counts.rbegin(), counts.rend(), filled).base();
  std::string text;
  for (auto it = first; it < last; ++it) {
    const double from = low + width * static_cast<double>(it - counts.begin());
    const std::size_t most = *std::max_element(counts.begin(), counts.end());
    // A bin that is not empty shows.
    const std::size_t length = (*it * kBarLength + most - 1) / most;
    text += fmt::format("  {:5.2f} - {:5.2f} {:7} {}\n", from, from + width, *it,
                        std::string(length, '#'));
  }
  return text;
}

std::string DescribeEpisodes(const std::vector<Episode>& episodes) {
  std::map<std::string, std::size_t> kinds;
  std::set<std::string> scenes;
  for (const Episode& episode : episodes) {
    ++kinds[KindOf(episode)];
    scenes.insert(episode.scene);
  }
  std::string text = fmt::format("{} episodes in {} scene{}\n", episodes.size(), scenes.size(),
                                 scenes.size() == 1 ? "" : "s");
  for (const auto& [kind, count] : kinds) text += fmt::format("  {:<22} {:7}\n", kind, count);
  const Ways ways = WaysOf(episodes);
  text += fmt::format("geodesic distance, metres ({})\n", Mean(ways.distances)) +
          TextHistogram(ways.distances, 0.0, 0.5, 60) +
          fmt::format("geodesic / straight line ({})\n", Mean(ways.ratios)) +
          TextHistogram(ways.ratios, 1.0, 0.1, 21);
  return text;
}

}  // namespace bulletnav::bench
