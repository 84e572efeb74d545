// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "benchmark/episodes/episode.h"
#include "benchmark/play/environment.h"
#include "benchmark/play/episode_result.h"

namespace bulletnav::bench {

/// When a lane whose episode is over gets the next one. kNextStep: in the next Step, whose action
/// for it is not looked at and worth nothing. kSameStep: at once, so that what is observed belongs
/// to the next episode. kNever: ResetLanes does it. Source: Gymnasium's AutoresetMode.
enum class Autoreset { kNextStep, kSameStep, kNever };

struct VectorSpec {
  Task task;
  std::vector<Episode> episodes;  // at least one
  int lanes = 1;
  int threads = 1;         // < 1: one per processor
  std::uint64_t seed = 0;  // of noise, and of the order
  bool shuffle = false;    // another order in each pass through the episodes, drawn from the seed
  Autoreset autoreset = Autoreset::kNextStep;
};

/// The world of a scene as episodes name it. Called from one thread.
using WorldSource = std::function<std::shared_ptr<const sim::World>(const std::string& scene)>;

/// Lanes that play episode after episode, for whoever learns: lane i of N plays number i, i + N,
/// i + 2N, ... of the episodes' order, which begins again at its end. What a lane sees is a
/// function of spec and actions, for any number of threads. All that is observed lies in one piece
/// of memory for each array, lane after lane, that stays where it is.
class VectorEnvironment {
 public:
  /// Throws sim::Error for no episodes or lanes, or a bad task.
  VectorEnvironment(VectorSpec spec, WorldSource worlds);
  ~VectorEnvironment();
  VectorEnvironment(const VectorEnvironment&) = delete;
  VectorEnvironment& operator=(const VectorEnvironment&) = delete;
  VectorEnvironment(VectorEnvironment&&) = delete;
  VectorEnvironment& operator=(VectorEnvironment&&) = delete;

  int lanes() const { return spec_.lanes; }
  const VectorSpec& spec() const { return spec_; }
  /// What is observed, for one lane: the sensors' arrays, then `goal.color` and `goal.depth` as far
  /// as the panorama has them.
  const std::vector<sim::ArraySpec>& arrays() const { return arrays_; }
  /// Array number i of all lanes: [lanes, shape...].
  std::span<const std::byte> memory(std::size_t i) const { return memory_[i]; }

  /// Begins anew in all lanes: as a new one with this seed would.
  void Reset(std::uint64_t seed);
  /// The next episodes of some lanes, rising; others stay as they are. Throws sim::Error for lanes
  /// that are not there, and before the first Reset.
  void ResetLanes(std::span<const int> lanes);
  /// One action for each lane. Throws sim::Error before the first Reset, if there are not as many
  /// actions as lanes, or for a lane whose episode is over and is not begun anew by itself.
  void Step(std::span<const sim::Action> actions);
  /// The same for some lanes, rising; others stay as they are, what was observed there too.
  void Step(std::span<const int> lanes, std::span<const sim::Action> actions);

  /// Of the last Step, of lanes that it moved: [lanes].
  std::span<const double> rewards() const { return rewards_; }
  std::span<const std::uint8_t> terminated() const { return terminated_; }
  std::span<const std::uint8_t> truncated() const { return truncated_; }

  /// An episode that ended in the last Step.
  struct Finished {
    int lane = 0;
    EpisodeResult result;
  };
  const std::vector<Finished>& finished() const { return finished_; }
  /// The episode that a lane is in. Throws sim::Error before the first Reset.
  const Episode& episode(int lane) const;
  /// Ground truth of a lane, for teachers and oracles.
  const GroundTruth& truth(int lane) const;

 private:
  void Start(int lane);
  bool Note(int lane, const StepOutcome& outcome);
  void TakeGoals();
  void RequireLanes(std::span<const int> lanes) const;
  void Require(bool is_right, const std::string& what) const;

  VectorSpec spec_;
  WorldSource worlds_;
  std::vector<sim::ArraySpec> arrays_;
  std::vector<std::span<const std::byte>> memory_;
  std::vector<std::uint8_t> goal_color_;
  std::vector<float> goal_depth_;
  std::vector<GroundTruth> truths_;
  std::unique_ptr<Environment> environment_;
  std::vector<std::uint64_t> next_;  // of each lane: its next number in the endless order
  std::vector<Episode> playing_;
  std::vector<double> rewards_;
  std::vector<std::uint8_t> terminated_;
  std::vector<std::uint8_t> truncated_;
  std::vector<Finished> finished_;
  bool is_begun_ = false;
};

}  // namespace bulletnav::bench
