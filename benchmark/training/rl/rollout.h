// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "benchmark/training/rl/actor_critic.h"
#include "benchmark/training/rl/gae.h"
#include "benchmark/training/rl/policy_task.h"
#include "benchmark/training/rl/running_moments.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// An episode that ended.
struct EndedEpisode {
  int lane = 0;
  std::uint64_t episode = 0;
  double score = 0.0;
  bool success = false;
  std::uint64_t steps = 0;
};

inline constexpr int kNoLesson = -1;  // see Lesson::counts

/// What was seen and done in all lanes; tensors [steps, lanes, ...].
struct Rollout {
  torch::Tensor numbers;
  torch::Tensor pictures;  // u8; undefined unless the net learns to see, or they are asked for
  torch::Tensor codes;     // what it made of them; undefined if it learns to see, or there are none
  torch::Tensor goals;     // u8 [goals, bytes] or, as above, codes [goals, code]
  torch::Tensor goal_index;  // [steps, lanes], of goals
  torch::Tensor starts;
  torch::Tensor actions;
  torch::Tensor lessons;            // the teacher's actions, or kNoLesson; undefined without one
  torch::Tensor log_probabilities;  // of the actions, when they were chosen
  torch::Tensor hidden;             // [lanes, width], before the first step
  std::vector<std::vector<LaneStep>> steps;  // [lanes][steps]
  std::vector<double> last_values;           // [lanes], after the last step
  std::vector<EndedEpisode> ended;

  /// What a net is shown of some lanes, encoded by it; `lanes`: i64.
  ActorCritic::Seen SeenBy(ActorCritic* net, const torch::Tensor& lanes) const;

 private:
  void SeeGoals(ActorCritic* net, const torch::Tensor& lanes, ActorCritic::Seen* seen) const;
};

/// The action of a step: a function of its key and the policy's probabilities.
struct ActionKey {
  std::uint64_t seed = 0;
  int lane = 0;
  std::uint64_t episode = 0;
  std::uint64_t step = 0;  // of the episode
};
/// `said`: what the policy says in that step; see ActorCritic::Draw.
int SampleAction(const ActionKey& key, const ActorCritic& policy, std::span<const float> said);

/// How lanes are played.
struct PlaySpec {
  int steps = 64;
  bool lessons = false;          // asks the teacher in each step
  double taught_episodes = 0.0;  // share of the episodes in which the teacher acts
  bool values = true;            // of the states, which only reinforcement needs
  bool pictures = false;         // are kept, whether or not the net learns to see
};

/// Plays lanes by a policy, from one rollout to the next. Lanes fall into groups that are asked
/// together, so that what a net says does not depend on the number of threads.
class Actor {
 public:
  /// `task`, `net` and `pool` must outlive it; `group` lanes are asked together. Begins the first
  /// episodes.
  Actor(PolicyTask* task, ActorCritic* net, sim::WorkerPool* pool, int group, std::uint64_t seed);

  /// `moments`: of returns, that the net's values are normalised by. Throws sim::Error if the first
  /// rollout does not fit into memory.
  Rollout Play(const PlaySpec& spec, const RunningMoments& moments);

  /// Of each lane the return, without discount, of the episodes that ended since the last call, and
  /// how many they are: [lanes, 2].
  std::vector<double> TakeReturns();

  /// Of lanes in which the teacher always acts nothing is asked while they play; their memory is
  /// what the update finds.
  void SetHidden(const torch::Tensor& hidden) { hidden_ = hidden.clone(); }

  /// Episodes, steps, starts, returns and memory of the lanes; the task has its own state.
  torch::Tensor hidden() const { return hidden_; }
  std::vector<float> State() const;
  void SetState(const std::vector<float>& state, const torch::Tensor& hidden);

 private:
  struct Return {
    float now = 0.0f;    // of the episode that is played
    float ended = 0.0f;  // of those that ended, all together
    float count = 0.0f;
  };
  struct Now;     // what is seen in a step
  struct Record;  // what was seen and done so far
  Now Observe();
  void EncodeGoals(const std::vector<std::int64_t>& lanes);
  /// Sets the codes of what was seen.
  ActorCritic::Output Ask(Now* now);
  Record BeginRecord(const PlaySpec& spec);
  void CheckMemory(const PlaySpec& spec, const Record& record) const;
  /// Of lanes whose goal is new.
  void AddGoals(const std::vector<std::int64_t>& lanes, Record* record);
  std::vector<int> Choose(const PlaySpec& spec, Record* record, ActorCritic::Output* output);
  void Stack(const Record& record, Rollout* rollout) const;
  void Act(const ActorCritic::Output& output, std::vector<int>* actions) const;
  bool IsTaught(std::size_t lane, double share) const;
  std::vector<double> ValuesOf(const torch::Tensor& values, const RunningMoments& moments) const;
  std::vector<double> ValuesHere(const RunningMoments& moments);
  void Begin(std::size_t lane, std::uint64_t episode);
  void LookAtGoal(std::size_t lane);
  static void EndReturn(Return* of_lane);
  std::vector<std::int64_t> BeginOver(const std::vector<LaneOutcome>& outcomes);
  std::size_t lanes() const { return episodes_.size(); }

  PolicyTask* task_;
  ActorCritic* net_;
  sim::WorkerPool* pool_;
  std::int64_t group_;
  std::uint64_t seed_;
  torch::Tensor hidden_;
  torch::Tensor starts_;  // [lanes]
  torch::Tensor goals_;   // u8 [lanes, bytes]
  torch::Tensor goal_codes_;
  std::vector<std::uint64_t> episodes_;
  std::vector<std::uint64_t> steps_;
  std::vector<Return> returns_;  // as floats, so that a checkpoint keeps them to the bit
  bool has_checked_memory_ = false;
};

}  // namespace bulletnav::bench
