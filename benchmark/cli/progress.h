// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace bulletnav::bench {

/// A line on standard error for work that takes over two seconds: what, how far, how long still.
/// On a terminal it rewrites itself; elsewhere it prints a line now and then. Thread-safe.
class Progress {
 public:
  Progress(std::string what, int total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;

  /// One more of `total` is done.
  void Advance();

 private:
  using Clock = std::chrono::steady_clock;
  void Show(double elapsed_s);

  std::string what_;
  int total_;
  bool is_terminal_;
  std::mutex mutex_;
  int done_ = 0;
  bool shown_ = false;
  Clock::time_point start_;
  Clock::time_point last_;
};

/// A new one, and what to call for each that is done.
std::function<void()> StartLine(const std::string& what, int total);

}  // namespace bulletnav::bench
