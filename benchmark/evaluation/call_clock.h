// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <mutex>
#include <optional>

namespace bulletnav::bench {

/// Times the calls that one thread makes into code that may never return, so that another can give
/// it up. Thread-safe.
class CallClock {
 public:
  using Clock = std::chrono::steady_clock;

  /// False if the thread was given up.
  bool Begin() {
    const std::lock_guard lock(mutex_);
    if (given_up_) return false;
    began_ = Clock::now();
    return true;
  }
  /// Seconds of the call; absent if the thread was given up meanwhile.
  std::optional<double> End() {
    const std::lock_guard lock(mutex_);
    if (given_up_) return std::nullopt;
    const double seconds = std::chrono::duration<double>(Clock::now() - *began_).count();
    began_.reset();
    return seconds;
  }
  /// Gives the thread up, and returns true, if it has been in a call for longer than `limit_s`.
  bool GiveUpAfter(double limit_s) {
    const std::lock_guard lock(mutex_);
    if (given_up_ || !began_) return false;
    given_up_ = std::chrono::duration<double>(Clock::now() - *began_).count() > limit_s;
    return given_up_;
  }

 private:
  std::mutex mutex_;
  std::optional<Clock::time_point> began_;
  bool given_up_ = false;
};

}  // namespace bulletnav::bench
