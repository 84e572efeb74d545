// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bulletnav::bench {

/// What came of one action in one lane.
struct LaneOutcome {
  double reward = 0.0;
  bool terminated = false;  // the episode ended: what would have followed counts for nothing
  bool truncated = false;   // it was cut: what is expected to follow counts
  double score = 0.0;       // of an episode that is over: 1 is the best that can be had
  bool success = false;

  bool is_over() const { return terminated || truncated; }
};

/// What a teacher who sees the truth does. `counts`: it is worth learning; not where the teacher
/// knows no way.
struct Lesson {
  int action = 0;
  bool counts = true;

  bool operator==(const Lesson&) const = default;
};

/// Lanes that a policy acts in, with observations as plain numbers and, if there are any, pictures
/// in bytes. A lane is a function of its number, the number of its episode and the actions.
class PolicyTask {
 public:
  PolicyTask() = default;
  virtual ~PolicyTask() = default;
  PolicyTask(const PolicyTask&) = delete;
  PolicyTask& operator=(const PolicyTask&) = delete;
  PolicyTask(PolicyTask&&) = delete;
  PolicyTask& operator=(PolicyTask&&) = delete;

  virtual int lanes() const = 0;
  /// Of those that a training has, where several processes share them; what a lane comes to
  /// follows from its number among all.
  virtual int first_lane() const { return 0; }
  virtual int actions() const = 0;                         // numbers of a choice; see ActorCritic
  virtual int observation_size() const = 0;                // numbers
  virtual std::size_t picture_bytes() const { return 0; }  // 0: there are no pictures

  /// Before a training's rollout; `done`: the share of the training that is behind it, from 0.
  virtual void StartRollout(double /*done*/) {}
  virtual void Begin(int lane, std::uint64_t episode) = 0;
  /// [lanes, observation_size] and [lanes, picture_bytes]
  virtual void Observe(std::span<float> numbers, std::span<std::uint8_t> pictures) = 0;
  virtual bool shows_goals() const { return true; }  // if there are pictures
  /// The picture of a lane's goal, [picture_bytes].
  virtual void ShowGoal(int /*lane*/, std::span<std::uint8_t> /*picture*/) const {}
  /// What a teacher would do, [lanes]. False: there is none.
  virtual bool Teach(std::span<Lesson> /*lessons*/) { return false; }
  /// An action and an outcome for each lane. An episode that is over stays as it is until Begin.
  virtual void Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) = 0;

  /// Where all lanes are, in whole numbers below 2^24, and back. After it, no lane's goal is as it
  /// was shown.
  virtual std::vector<float> State() const = 0;
  /// Expects: what State gave, of a task of the same config.
  virtual void SetState(std::span<const float> state) = 0;
};

}  // namespace bulletnav::bench
