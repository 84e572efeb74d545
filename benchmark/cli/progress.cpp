// SPDX-License-Identifier: MIT
#include "benchmark/cli/progress.h"

#include <cstdio>
#include <memory>

#include <fmt/core.h>
#include <unistd.h>

namespace bulletnav::bench {
namespace {

constexpr double kQuietS = 2.0;  // shorter work says nothing
constexpr double kTerminalStepS = 0.2;
constexpr double kLogStepS = 10.0;

double Seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

/// "12.3 a second", or what one takes where that would be next to nothing.
std::string Rate(int done, double elapsed_s) {
  if (done >= elapsed_s) return fmt::format("{:.1f} a second", done / elapsed_s);
  return fmt::format("{:.0f} s each", elapsed_s / done);
}

}  // namespace

Progress::Progress(std::string what, int total)
    : what_(std::move(what)),
      total_(total),
      is_terminal_(::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (shown_ && is_terminal_) std::fputc('\n', stderr);
}

void Progress::Advance() {
  const std::lock_guard lock(mutex_);
  ++done_;
  const Clock::time_point now = Clock::now();
  const double elapsed = Seconds(now - start_);
  const double step = is_terminal_ ? kTerminalStepS : kLogStepS;
  const bool due = elapsed >= kQuietS && Seconds(now - last_) >= step;
  if (due || (shown_ && done_ == total_)) {
    Show(elapsed);
    last_ = now;
  }
}

void Progress::Show(double elapsed_s) {
  const double left_s = elapsed_s / done_ * (total_ - done_);
  const std::string line = fmt::format("{} {}/{}, {}, {:.0f} s left", what_, done_, total_,
                                       Rate(done_, elapsed_s), left_s);
  if (is_terminal_) {
    fmt::print(stderr, "\r{}\033[K", line);
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
  shown_ = true;
}

std::function<void()> StartLine(const std::string& what, int total) {
  const auto line = std::make_shared<Progress>(what, total);
  return [line] {
    line->Advance();
  };
}

}  // namespace bulletnav::bench
