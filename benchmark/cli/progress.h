// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>

#include "benchmark/cli/live_text.h"

namespace bulletnav::bench {

/// A line on standard error for work that takes over two seconds: what, how far, how long still.
/// Thread-safe.
class Progress {
 public:
  Progress(std::string what, int total);
  /// Of work without parts: what, and how long it takes by now.
  explicit Progress(std::string what);

  /// What is being done from now on.
  void Rename(std::string what);
  /// One more of `total` is done; the line ends with the last.
  void Advance();

 private:
  std::string Line(double elapsed_s) const;

  std::string what_;
  int total_;  // kUncounted: of work without parts
  int done_ = 0;
  LiveText line_;
};

/// A new one, and what to call for each that is done.
std::function<void()> StartLine(const std::string& what, int total);

}  // namespace bulletnav::bench
