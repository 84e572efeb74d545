// SPDX-License-Identifier: MIT
#include "benchmark/cli/run_progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/core.h>
#include <unistd.h>

namespace bulletnav::bench {
namespace {

constexpr double kQuietS = 2.0;
constexpr double kLogStepS = 20.0;

std::string Duration(double seconds) {
  const auto s = std::lround(seconds);
  if (s < 90) return fmt::format("{} s", s);
  if (s < 5400) return fmt::format("{} min", (s + 30) / 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

}  // namespace

void RunProgress::Begin(std::size_t total, std::span<const EpisodeResult> before) {
  total_ = total;
  before_ = before.size();
  done_ = before.size();
  for (const EpisodeResult& result : before) Count(result);
  if (before_ > 0) fmt::print(stderr, "going on after {} of {} episodes\n", before_, total_);
  if (done_ == total_) return;
  table_.emplace(
      [this](double elapsed_s) {
        return Text(elapsed_s);
      },
      kQuietS, kLogStepS);
}

void RunProgress::Add(const EpisodeResult& result) {
  table_.value().Change([&] {
    ++done_;
    Count(result);
    for (const GoalMetrics& goal : result.goals) steps_ += goal.Whole("steps");
  });
}

void RunProgress::End() {
  if (table_) table_->End(/*always=*/done_ > before_);
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

std::string RunProgress::Text(double elapsed_s) const {
  if (done_ == before_) return fmt::format("until the first episode ends, {:.0f} s\n", elapsed_s);
  const double elapsed = std::max(1e-3, elapsed_s);
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

}  // namespace bulletnav::bench
