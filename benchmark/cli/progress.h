// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace bulletnav::bench {

/// A line on standard error for work that takes over two seconds: what, how far, how long still.
/// On a terminal it rewrites itself; elsewhere it prints a line now and then. It keeps on while
/// nothing is done, so that long parts are not silent. Thread-safe.
class Progress {
 public:
  Progress(std::string what, int total);
  /// Of work without parts: what, and how long it takes by now.
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;

  /// What is being done from now on.
  void Rename(std::string what);
  /// One more of `total` is done; the line ends with the last.
  void Advance();

 private:
  using Clock = std::chrono::steady_clock;
  void Watch(const std::stop_token& stop);
  void ShowIfDue();
  void Show(double elapsed_s);
  std::string Line(double elapsed_s) const;

  std::string what_;
  int total_;  // kUncounted: of work without parts
  bool is_terminal_;
  std::mutex mutex_;
  std::condition_variable_any ended_;
  int done_ = 0;
  bool shown_ = false;
  Clock::time_point start_;
  Clock::time_point last_;
  std::jthread watch_;
};

/// A new one, and what to call for each that is done.
std::function<void()> StartLine(const std::string& what, int total);

}  // namespace bulletnav::bench
