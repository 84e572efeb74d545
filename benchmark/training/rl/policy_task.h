// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace bulletnav::bench {

/// What came of one action in one lane.
struct LaneOutcome {
  double reward = 0.0;
  bool terminated = false;
  bool truncated = false;
  double score = 0.0;  // of an episode that is over: 1 is the best that can be had
};

/// Lanes that a policy acts in, with observations as plain numbers. A lane is a function of its
/// number, the number of its episode and the actions.
class PolicyTask {
 public:
  PolicyTask() = default;
  virtual ~PolicyTask() = default;
  PolicyTask(const PolicyTask&) = delete;
  PolicyTask& operator=(const PolicyTask&) = delete;
  PolicyTask(PolicyTask&&) = delete;
  PolicyTask& operator=(PolicyTask&&) = delete;

  virtual int lanes() const = 0;
  virtual int actions() const = 0;
  virtual int observation_size() const = 0;

  virtual void Begin(int lane, std::uint64_t episode) = 0;
  /// [lanes, observation_size]
  virtual void Observe(std::span<float> out) const = 0;
  /// An action and an outcome for each lane. An episode that is over stays as it is until Begin.
  virtual void Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) = 0;

  /// Where all lanes are, in whole numbers below 2^24, and back.
  virtual std::vector<float> State() const = 0;
  virtual void SetState(std::span<const float> state) = 0;
};

}  // namespace bulletnav::bench
