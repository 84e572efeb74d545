// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "agent/foreign_agent.h"

namespace bulletnav::bench {

/// Looks after the calls of foreign agents, in a thread of its own that the first of them starts:
/// interrupts a call that takes longer than it may, again and again, and gives it up if it has not
/// come back after that long once more, 2 seconds at least and a minute at most. Thread-safe.
class CallWatch {
 public:
  /// Called once for a call that is given up, in the watch's thread.
  using GiveUp = std::function<void(const agent::ForeignCall&)>;

  /// `agent` must live until it is removed.
  void Add(agent::ForeignAgent* agent, GiveUp give_up);
  void Remove(agent::ForeignAgent* agent);

 private:
  struct Entry {
    GiveUp give_up;
    double next_s = 0.0;  // when the call that is at work is interrupted next
    bool is_given_up = false;
  };
  void Watch(const std::stop_token& stop);
  static void Look(agent::ForeignAgent* agent, Entry* entry);

  std::mutex mutex_;
  std::map<agent::ForeignAgent*, Entry> entries_;
  std::jthread thread_;  // the last, to be joined first
};

}  // namespace bulletnav::bench
