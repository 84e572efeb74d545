// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "benchmark/episodes/episode.h"
#include "benchmark/play/metrics.h"

namespace bulletnav::bench {

/// What tells one result of a run from all others.
struct ResultKey {
  std::string agent;
  std::string setting;    // "rgb" or "rgbd"
  std::string condition;  // "noise", "no_noise" or "no_stop"
  std::uint64_t seed = 0;
  std::string scene;
  std::string episode;

  bool operator==(const ResultKey&) const = default;
  auto Order() const { return std::tie(agent, setting, condition, seed, scene, episode); }
  bool operator<(const ResultKey& other) const { return Order() < other.Order(); }
};

/// How an agent fared in one episode.
struct EpisodeResult {
  ResultKey key;
  std::optional<Difficulty> difficulty;
  std::vector<GoalMetrics> goals;  // in the episode's order; at least one
  std::string failure;             // why the agent was taken off, such as a throw; else empty

  bool operator==(const EpisodeResult&) const = default;
};

/// One line of JSON, without its end: key, difficulty, failure, then the metrics, or the list
/// `goals` of them if there are several. Infinite distances are null. The same result gives the
/// same bytes, and reading them gives the same result, bit for bit.
std::string ToJsonLine(const EpisodeResult& result);
/// Throws sim::FileError at file:line.
EpisodeResult FromJsonLine(std::string_view line, const std::filesystem::path& file,
                           int line_number);

}  // namespace bulletnav::bench
