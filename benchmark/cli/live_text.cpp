// SPDX-License-Identifier: MIT
#include "benchmark/cli/live_text.h"

#include <algorithm>
#include <cstdio>

#include <fmt/core.h>
#include <unistd.h>

namespace bulletnav::bench {
namespace {

constexpr double kTerminalStepS = 0.25;
constexpr std::chrono::milliseconds kWatchStep(250);

double Seconds(LiveText::Clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

LiveText::LiveText(std::function<std::string(double)> text, double quiet_s, double log_step_s)
    : text_(std::move(text)),
      quiet_s_(quiet_s),
      is_terminal_(::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      shown_(start_) {
  step_s_ = is_terminal_ ? kTerminalStepS : log_step_s;
  watch_ = std::jthread([this](const std::stop_token& stop) {
    Watch(stop);
  });
}

LiveText::~LiveText() {
  watch_.request_stop();
  watch_.join();
}

void LiveText::End(bool always) {
  const std::lock_guard lock(mutex_);
  if (has_ended_) return;
  has_ended_ = true;
  if (was_shown_ || always) Show();
}

void LiveText::Watch(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    ended_.wait_for(lock, stop, kWatchStep, [] {
      return false;
    });
    const Clock::time_point now = Clock::now();
    const bool is_due =
        Seconds(now - start_) >= quiet_s_ && (!was_shown_ || Seconds(now - shown_) >= step_s_);
    if (is_due && !has_ended_ && !stop.stop_requested()) Show();
  }
}

void LiveText::Show() {
  const Clock::time_point now = Clock::now();
  const std::string text = text_(Seconds(now - start_));
  std::string out;
  if (is_terminal_) {
    if (lines_ > 0) out = fmt::format("\033[{}A\033[J", lines_);
    lines_ = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  }
  out += text;
  std::fwrite(out.data(), 1, out.size(), stderr);
  std::fflush(stderr);
  shown_ = now;
  was_shown_ = true;
}

}  // namespace bulletnav::bench
