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
constexpr std::chrono::milliseconds kWatchStep(250);
constexpr int kUncounted = -1;

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
      last_(start_),
      watch_([this](const std::stop_token& stop) {
        Watch(stop);
      }) {}

Progress::Progress(std::string what) : Progress(std::move(what), kUncounted) {}

Progress::~Progress() {
  watch_.request_stop();
  watch_.join();
  if (shown_ && is_terminal_) std::fputc('\n', stderr);
}

void Progress::Rename(std::string what) {
  const std::lock_guard lock(mutex_);
  what_ = std::move(what);
}

void Progress::Advance() {
  const std::lock_guard lock(mutex_);
  ++done_;
  if (done_ == total_ && shown_) Show(Seconds(Clock::now() - start_));
  if (done_ == total_) watch_.request_stop();
  ShowIfDue();
}

void Progress::Watch(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    ended_.wait_for(lock, stop, kWatchStep, [] {
      return false;
    });
    ShowIfDue();
  }
}

void Progress::ShowIfDue() {
  if (done_ == total_) return;
  const Clock::time_point now = Clock::now();
  const double elapsed = Seconds(now - start_);
  if (elapsed < kQuietS) return;
  if (shown_ && Seconds(now - last_) < (is_terminal_ ? kTerminalStepS : kLogStepS)) return;
  last_ = now;
  Show(elapsed);
}

void Progress::Show(double elapsed_s) {
  if (is_terminal_) {
    fmt::print(stderr, "\r{}\033[K", Line(elapsed_s));
  } else {
    fmt::print(stderr, "{}\n", Line(elapsed_s));
  }
  std::fflush(stderr);
  shown_ = true;
}

std::string Progress::Line(double elapsed_s) const {
  if (total_ == kUncounted) return fmt::format("{}, {:.0f} s", what_, elapsed_s);
  if (done_ == 0) return fmt::format("{} 0/{}, {:.0f} s so far", what_, total_, elapsed_s);
  const double left_s = elapsed_s / done_ * (total_ - done_);
  return fmt::format("{} {}/{}, {}, {:.0f} s left", what_, done_, total_, Rate(done_, elapsed_s),
                     left_s);
}

std::function<void()> StartLine(const std::string& what, int total) {
  const auto line = std::make_shared<Progress>(what, total);
  return [line] {
    line->Advance();
  };
}

}  // namespace bulletnav::bench
