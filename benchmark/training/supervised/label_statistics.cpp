// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/label_statistics.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include <fmt/core.h>

namespace bulletnav::bench {
namespace {

double Share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

constexpr int kBarLength = 40;

}  // namespace

void LabelStatistics::Add(const SceneSamples& samples) {
  ++scenes_;
  points_ += samples.count();
  for (const std::uint16_t bits : samples.explorable) {
    explorable_ += std::popcount(bits);
    without_explorable_ += bits == 0 ? 1 : 0;
  }
  for (int source = 0; source < samples.count(); ++source) {
    for (int goal = 0; goal < samples.count(); ++goal) {
      ++pairs_;
      const PairLabel& label = samples.pair(source, goal);
      if (source != goal) ++different_;
      if (source != goal && label.same_node != 0) ++connected_;
      if (label.same_node == 0) AddScores(label);
    }
  }
}

void LabelStatistics::AddScores(const PairLabel& label) {
  for (int i = 0; i < agent::kDirections; ++i) {
    const int bin = static_cast<int>(label.far_score(i) * kScoreBins);
    ++scores_[static_cast<std::size_t>(std::min(bin, kScoreBins - 1))];
  }
}

double LabelStatistics::connected_share() const {
  return Share(connected_, different_);
}

double LabelStatistics::mean_explorable() const {
  return Share(explorable_, points_);
}

double LabelStatistics::share_without_explorable() const {
  return Share(without_explorable_, points_);
}

std::string LabelStatistics::ToText() const {
  std::string text = fmt::format(
      "{} scenes, {} points, {} pairs\n{:.2f}% of the pairs of different points are of one node\n"
      "{:.2f} of {} directions are explorable, on average; none at {:.1f}% of the points\n"
      "scores of pairs that are not of one node:\n",
      scenes_, points_, pairs_, 100.0 * connected_share(), mean_explorable(), agent::kDirections,
      100.0 * share_without_explorable());
  const std::int64_t sum = std::accumulate(scores_.begin(), scores_.end(), std::int64_t{0});
  const std::int64_t most = *std::max_element(scores_.begin(), scores_.end());
  for (std::size_t bin = 0; bin < scores_.size(); ++bin) {
    const auto length = static_cast<std::size_t>(kBarLength * Share(scores_[bin], most));
    text += fmt::format("  {:.1f}-{:.1f} {:5.1f}% {}\n", 0.1 * static_cast<double>(bin),
                        0.1 * static_cast<double>(bin + 1), 100.0 * Share(scores_[bin], sum),
                        std::string(length, '#'));
  }
  return text;
}

}  // namespace bulletnav::bench
