// SPDX-License-Identifier: MIT
#include "benchmark/cli/run_progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/core.h>
#include <unistd.h>

namespace bulletnav::bench {
namespace {

constexpr double kTerminalStepS = 0.5;
constexpr double kLogStepS = 20.0;

double Seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

std::string Duration(double seconds) {
  const auto s = std::lround(seconds);
  if (s < 90) return fmt::format("{} s", s);
  if (s < 5400) return fmt::format("{} min", (s + 30) / 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

}  // namespace

RunProgress::RunProgress() : is_terminal_(::isatty(STDERR_FILENO) == 1) {}

void RunProgress::Begin(std::size_t total, std::span<const EpisodeResult> before) {
  total_ = total;
  before_ = before.size();
  done_ = before.size();
  for (const EpisodeResult& result : before) Count(result);
  start_ = Clock::now();
  shown_ = start_;
  loading_.reset();
  if (done_ < total_) loading_.emplace("until the first episode ends");
  if (before_ > 0) fmt::print(stderr, "going on after {} of {} episodes\n", before_, total_);
}

void RunProgress::Add(const EpisodeResult& result) {
  loading_.reset();
  ++done_;
  Count(result);
  for (const GoalMetrics& goal : result.goals) steps_ += goal.Whole("steps");
  const Clock::time_point now = Clock::now();
  if (Seconds(now - shown_) < (is_terminal_ ? kTerminalStepS : kLogStepS)) return;
  shown_ = now;
  Show();
}

void RunProgress::End() {
  loading_.reset();
  if (done_ > before_) Show();
}

void RunProgress::Count(const EpisodeResult& result) {
  const ResultKey& key = result.key;
  auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& other) {
    return other.agent == key.agent && other.setting == key.setting &&
           other.condition == key.condition;
  });
  if (row == rows_.end()) {
    row = rows_.insert(rows_.end(), {key.agent, key.setting, key.condition, 0, 0, 0.0, 0.0, 0.0});
  }
  ++row->episodes;
  row->failed += result.failure.empty() ? 0 : 1;
  const auto goals = static_cast<double>(result.goals.size());
  for (const GoalMetrics& goal : result.goals) {
    row->success += (goal.success() ? 1.0 : 0.0) / goals;
    row->spl += goal.Value("spl") / goals;
    row->steps += goal.Whole("steps");
  }
}

std::string RunProgress::Text() const {
  const double elapsed = std::max(1e-3, Seconds(Clock::now() - start_));
  const auto played = static_cast<double>(done_ - before_);
  std::string text = fmt::format("{:<24} {:<4} {:<8} {:>8} {:>7} {:>6} {:>6} {:>6}\n", "agent", "",
                                 "", "episodes", "success", "SPL", "steps", "failed");
  for (const Row& row : rows_) {
    text += fmt::format("{:<24} {:<4} {:<8} {:>8} {:>7.2f} {:>6.2f} {:>6.0f} {:>6}\n", row.agent,
                        row.setting, row.condition, row.episodes, row.success / row.episodes,
                        row.spl / row.episodes, row.steps / row.episodes, row.failed);
  }
  text += fmt::format("{}/{} episodes, {:.1f} a second, {:.0f} steps/s, ", done_, total_,
                      played / elapsed, steps_ / elapsed);
  text += done_ == total_
              ? "took " + Duration(elapsed)
              : Duration(elapsed / played * static_cast<double>(total_ - done_)) + " left";
  return text + "\n";
}

void RunProgress::Show() {
  const std::string text = Text();
  std::string out;
  if (is_terminal_) {
    if (lines_ > 0) out = fmt::format("\033[{}A\033[J", lines_);
    lines_ = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  }
  out += text;
  std::fwrite(out.data(), 1, out.size(), stderr);
  std::fflush(stderr);
}

}  // namespace bulletnav::bench
