// SPDX-License-Identifier: MIT
#include "benchmark/runs/call_watch.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <utility>

namespace bulletnav::bench {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks(20);
constexpr double kLeastGrace = 2.0;  // seconds
constexpr double kMostGrace = 60.0;
constexpr int kInterrupts = 4;  // of one call; code may catch what it is interrupted with

}  // namespace

void CallWatch::Add(agent::ForeignAgent* agent, GiveUp give_up) {
  const std::lock_guard lock(mutex_);
  entries_[agent] = {std::move(give_up)};
  if (thread_.joinable()) return;
  thread_ = std::jthread([this](const std::stop_token& stop) {
    Watch(stop);
  });
}

void CallWatch::Remove(agent::ForeignAgent* agent) {
  const std::lock_guard lock(mutex_);
  entries_.erase(agent);
}

void CallWatch::Watch(const std::stop_token& stop) {
  std::condition_variable_any woken;
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    for (auto& [agent, entry] : entries_) Look(agent, &entry);
    woken.wait_for(lock, stop, kBetweenLooks, [] {
      return false;
    });
  }
}

void CallWatch::Look(agent::ForeignAgent* agent, Entry* entry) {
  const std::optional<agent::ForeignCall> call = agent->busy();
  const double limit = agent->time_limit_s();
  if (!call || call->seconds < limit) {
    entry->next_s = limit;
    entry->is_given_up = false;
    return;
  }
  const double grace = std::clamp(limit, kLeastGrace, kMostGrace);
  if (call->seconds >= limit + grace && !entry->is_given_up) {
    entry->is_given_up = true;
    entry->give_up(*call);
    return;
  }
  if (call->seconds < entry->next_s) return;
  entry->next_s = call->seconds + grace / kInterrupts;
  agent->Interrupt();
}

}  // namespace bulletnav::bench
