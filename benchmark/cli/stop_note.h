// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <csignal>
#include <functional>
#include <string>
#include <thread>

namespace bulletnav::bench {

/// While one lives, SIGINT and SIGTERM end the program with one line on standard error, without
/// half-written files, and with the status 130 or 143; a second one ends it at once. Signals that
/// were ignored stay so. Signals are the process's: where one lives already, another does nothing.
class StopWatch {
 public:
  StopWatch();
  ~StopWatch();
  StopWatch(const StopWatch&) = delete;
  StopWatch& operator=(const StopWatch&) = delete;
  StopWatch(StopWatch&&) = delete;
  StopWatch& operator=(StopWatch&&) = delete;

 private:
  bool is_first_;
  std::array<int, 2> pipe_ = {-1, -1};
  std::array<struct sigaction, 2> before_ = {};
  std::thread thread_;
};

/// What the line says while one lives: what is kept, and how to go on. The newest one counts.
class StopNote {
 public:
  /// `text` is called from another thread, while this lives.
  explicit StopNote(std::function<std::string()> text);
  ~StopNote();
  StopNote(const StopNote&) = delete;
  StopNote& operator=(const StopNote&) = delete;
  StopNote(StopNote&&) = delete;
  StopNote& operator=(StopNote&&) = delete;

 private:
  std::function<std::string()> text_;
  friend class StopWatch;
  static std::string Newest();
};

}  // namespace bulletnav::bench
