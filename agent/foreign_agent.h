// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

namespace bulletnav::agent {

/// A call of an agent that is at work.
struct ForeignCall {
  int lane = 0;
  double seconds = 0.0;  // since it began
};

/// What a BatchAgent is besides if its answers come from somebody else's code, as Python's: code
/// that may never answer, and that no version of the program tells of. Whoever plays episodes looks
/// after it by this. The only place where a clock decides anything: an agent that is quick enough
/// is not told of it.
class ForeignAgent {
 public:
  ForeignAgent() = default;
  virtual ~ForeignAgent() = default;
  ForeignAgent(const ForeignAgent&) = delete;
  ForeignAgent& operator=(const ForeignAgent&) = delete;
  ForeignAgent(ForeignAgent&&) = delete;
  ForeignAgent& operator=(ForeignAgent&&) = delete;

  /// Seconds that one call of one lane may take.
  virtual double time_limit_s() const = 0;
  /// The call that is at work; absent between calls, and while one waits for other agents. From any
  /// thread.
  virtual std::optional<ForeignCall> busy() const = 0;
  /// Makes the call that is at work throw, if it can; returns at once. From any thread.
  virtual void Interrupt() = 0;
  /// The files of its code, what it is in first, in an order that stays.
  virtual std::vector<std::filesystem::path> sources() const = 0;
};

}  // namespace bulletnav::agent
