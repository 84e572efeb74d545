// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/cli/live_text.h"
#include "benchmark/play/episode_result.h"

namespace bulletnav::bench {

/// The table of a run as it fills, with rate and time left, on standard error. Not thread-safe.
class RunProgress {
 public:
  void Begin(std::size_t total, std::span<const EpisodeResult> before);
  void Add(const EpisodeResult& result);
  /// The last word.
  void End();

 private:
  /// One agent under one condition, all difficulties and seeds together.
  struct Row {
    std::string agent;
    std::string setting;
    std::string condition;
    int episodes = 0;
    int failed = 0;
    double success = 0.0;  // sums over episodes
    double spl = 0.0;
    double steps = 0.0;
  };

  void Count(const EpisodeResult& result);
  std::string Text(double elapsed_s) const;

  std::size_t total_ = 0;
  std::size_t before_ = 0;
  std::size_t done_ = 0;
  double steps_ = 0.0;  // since this process started
  std::vector<Row> rows_;
  std::optional<LiveText> table_;
};

}  // namespace bulletnav::bench
