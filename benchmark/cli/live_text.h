// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace bulletnav::bench {

/// How work goes, in some lines on standard error: on a terminal they are rewritten in place, else
/// printed now and then. Shown from a thread of its own, so that long parts are not silent.
/// Thread-safe.
class LiveText {
 public:
  using Clock = std::chrono::steady_clock;

  /// `text` gives whole lines, each with its end, for the seconds since the start; it is never
  /// called twice at once, nor while Change changes what it reads. Work that ends within
  /// `quiet_s` seconds shows nothing; where there is no terminal, lines come every `log_step_s`.
  LiveText(std::function<std::string(double elapsed_s)> text, double quiet_s, double log_step_s);
  /// Shows nothing more.
  ~LiveText();
  LiveText(const LiveText&) = delete;
  LiveText& operator=(const LiveText&) = delete;
  LiveText(LiveText&&) = delete;
  LiveText& operator=(LiveText&&) = delete;

  /// Changes what the text is made of.
  template <class F>
  void Change(F change) {
    const std::lock_guard lock(mutex_);
    change();
  }
  /// The last word: shows the text as it is now, if it was shown before or `always`, and no more.
  void End(bool always);

 private:
  void Watch(const std::stop_token& stop);
  void Show();

  std::function<std::string(double)> text_;
  double quiet_s_;
  double step_s_;
  bool is_terminal_;
  Clock::time_point start_;
  Clock::time_point shown_;
  std::mutex mutex_;
  std::condition_variable_any ended_;
  int lines_ = 0;  // on the terminal that are ours
  bool was_shown_ = false;
  bool has_ended_ = false;
  std::jthread watch_;
};

}  // namespace bulletnav::bench
