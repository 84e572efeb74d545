// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/cli/progress.h"
#include "benchmark/play/episode_result.h"

namespace bulletnav::bench {

/// The table of a run as it fills, with rate and time left, on standard error: rewritten in place
/// on a terminal, else printed now and then. Not thread-safe.
class RunProgress {
 public:
  RunProgress();

  void Begin(std::size_t total, std::span<const EpisodeResult> before);
  void Add(const EpisodeResult& result);
  /// The last word.
  void End();

 private:
  using Clock = std::chrono::steady_clock;
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
  void Show();
  std::string Text() const;

  bool is_terminal_;
  std::size_t total_ = 0;
  std::size_t before_ = 0;
  std::size_t done_ = 0;
  double steps_ = 0.0;  // since this process started
  std::vector<Row> rows_;
  Clock::time_point start_;
  Clock::time_point shown_;
  std::optional<Progress> loading_;  // until the first episode ends
  int lines_ = 0;                    // on the terminal that belong to the table
};

}  // namespace bulletnav::bench
