// SPDX-License-Identifier: MIT
#pragma once
#include <mutex>
#include <optional>

namespace bulletnav::bench {

/// Times the calls that one thread makes into code that may never return, so that another can give
/// it up. Time is counted in ticks of that other thread, not on a clock: a program that was stopped
/// for a night, or waits for a busy machine, does not hold it against the call. Thread-safe.
class CallClock {
 public:
  /// False if the thread was given up.
  bool Begin() {
    const std::lock_guard lock(mutex_);
    is_in_call_ = !is_given_up_;
    seconds_ = 0.0;
    return is_in_call_;
  }
  /// Seconds of the call; absent if the thread was given up meanwhile.
  std::optional<double> End() {
    const std::lock_guard lock(mutex_);
    if (is_given_up_) return std::nullopt;
    is_in_call_ = false;
    return seconds_;
  }
  /// `seconds` more have passed. Gives the thread up, and returns true, if it has been in a call
  /// for longer than `limit_s`.
  bool Tick(double seconds, double limit_s) {
    const std::lock_guard lock(mutex_);
    if (is_given_up_ || !is_in_call_) return false;
    seconds_ += seconds;
    is_given_up_ = seconds_ > limit_s;
    return is_given_up_;
  }

 private:
  std::mutex mutex_;
  bool is_in_call_ = false;
  bool is_given_up_ = false;
  double seconds_ = 0.0;
};

}  // namespace bulletnav::bench
