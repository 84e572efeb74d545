// SPDX-License-Identifier: MIT
#pragma once
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <vector>

#include "benchmark/runs/run_config.h"

namespace bulletnav::bench {

/// One agent under one condition with one seed.
struct RunRow {
  std::size_t agent = 0;  // among the run's
  std::string setting;
  Condition condition = Condition::kNoise;
  std::uint64_t seed = 0;
};

/// One episode of one row.
struct RunJob {
  std::size_t row = 0;
  std::size_t episode = 0;
  bool alone = false;  // not in one batch with others, one of which has failed
};

/// Jobs that workers take in turn, until none is left or one of them gives up. Thread-safe.
class RunQueue {
 public:
  explicit RunQueue(std::vector<RunJob> jobs) : jobs_(jobs.begin(), jobs.end()) {}

  std::optional<RunJob> Take();
  /// The next job, if it is of the same row and may be batched.
  std::optional<RunJob> TakeOfRow(std::size_t row);
  void PutBackAlone(RunJob job);
  /// Ends the queue; the first exception is kept.
  void Abort(std::exception_ptr failure);
  bool aborted() const;
  /// Throws what the queue was aborted with.
  void Rethrow() const;

 private:
  mutable std::mutex mutex_;
  std::deque<RunJob> jobs_;
  std::exception_ptr failure_;
};

}  // namespace bulletnav::bench
