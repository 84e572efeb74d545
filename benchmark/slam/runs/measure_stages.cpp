// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/measure_stages.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "agent/slam/topology/sequences.h"
#include "benchmark/slam/metrics/detection_figures.h"
#include "sim/base/check.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {
namespace {

constexpr double kPlaceMetres = 2.0;
constexpr double kPlaceTurn = std::numbers::pi / 4.0;
constexpr int kShortest = 3;  // frames of a sequence of a true place, as detectors have it

/// Sequences, and which of them are joined, each with itself at least.
class Joins {
 public:
  Joins(const std::vector<agent::Sequence>& sequences, int frames)
      : count_(sequences.size()),
        of_frame_(static_cast<std::size_t>(frames)),
        joined_(count_ * count_) {
    for (std::size_t i = 0; i < count_; ++i) {
      for (int frame = sequences[i].first; frame <= sequences[i].last; ++frame) {
        of_frame_.at(static_cast<std::size_t>(frame)) = i;
      }
    }
  }

  void JoinSequences(std::size_t later, std::size_t earlier) {
    joined_.at(later * count_ + earlier) = 1;
  }
  void JoinOf(const agent::LoopCandidate& pair) { joined_[At(pair.later, pair.earlier)] = 1; }
  bool AreJoined(int later, int earlier) const { return joined_[At(later, earlier)] != 0; }

 private:
  std::size_t At(int later, int earlier) const {
    return of_frame_[static_cast<std::size_t>(later)] * count_ +
           of_frame_[static_cast<std::size_t>(earlier)];
  }

  std::size_t count_;
  std::vector<std::size_t> of_frame_;
  std::vector<std::uint8_t> joined_;
};

bool IsLoop(const LoopTruth& truth, const agent::LoopCandidate& pair) {
  return truth.Is(LoopKind::kCovisible, pair.later, pair.earlier);
}

/// Average precision of the flat comparison within sequences that hold a covisible pair.
double WithTrueJoins(const std::vector<agent::Sequence>& sequences,
                     std::span<const agent::LoopCandidate> flat, const LoopTruth& truth) {
  Joins joins(sequences, truth.frames());
  for (const agent::LoopCandidate& pair : flat) {
    if (IsLoop(truth, pair)) joins.JoinOf(pair);
  }
  std::vector<Answer> answers;
  for (const agent::LoopCandidate& pair : flat) {
    if (!joins.AreJoined(pair.later, pair.earlier)) continue;
    answers.push_back({static_cast<float>(pair.score), IsLoop(truth, pair)});
  }
  return MeasureDetection(std::move(answers), {truth.Count(LoopKind::kCovisible), truth.pairs()})
      .average_precision;
}

bool IsOnePlace(const sim::BodyPose& first, const sim::BodyPose& pose) {
  const sim::PlanarPose seen = sim::RelativePose(first, pose);
  return std::hypot(seen.x, seen.y) <= kPlaceMetres &&
         std::abs(sim::WrapAngle(seen.yaw)) <= kPlaceTurn;
}

std::vector<agent::Sequence> TruePlaces(std::span<const sim::BodyPose> poses) {
  std::vector<sim::BodyPose> firsts;
  std::vector<int> places;
  places.reserve(poses.size());
  for (const sim::BodyPose& pose : poses) {
    const auto place = std::find_if(firsts.begin(), firsts.end(), [&](const auto& first) {
      return IsOnePlace(first, pose);
    });
    places.push_back(static_cast<int>(place - firsts.begin()));
    if (place == firsts.end()) firsts.push_back(pose);
  }
  return agent::SequencesOf(places, kShortest);
}

}  // namespace

std::optional<StageOutcome> MeasureStages(const agent::SequenceTrace& trace,
                                          std::span<const agent::LoopCandidate> flat,
                                          const LoopTruth& truth,
                                          std::span<const sim::BodyPose> poses) {
  BULLETNAV_CHECK_EQ(static_cast<int>(poses.size()), truth.frames());
  const std::int64_t loops = truth.Count(LoopKind::kCovisible);
  if (loops == 0 || truth.pairs() == 0) return std::nullopt;
  Joins joins(trace.sequences, truth.frames());
  for (std::size_t i = 0; i < trace.sequences.size(); ++i) joins.JoinSequences(i, i);
  for (const auto& [later, earlier] : trace.joined) {
    joins.JoinSequences(static_cast<std::size_t>(later), static_cast<std::size_t>(earlier));
  }
  std::int64_t compared = 0;
  std::int64_t within = 0;
  for (int later = 0; later < truth.frames(); ++later) {
    for (int earlier = 0; earlier < truth.compared(later); ++earlier) {
      if (!joins.AreJoined(later, earlier)) continue;
      ++compared;
      if (truth.Is(LoopKind::kCovisible, later, earlier)) ++within;
    }
  }
  StageOutcome outcome;
  outcome.compared = static_cast<double>(compared) / static_cast<double>(truth.pairs());
  outcome.within = static_cast<double>(within) / static_cast<double>(loops);
  outcome.true_joins = WithTrueJoins(trace.sequences, flat, truth);
  outcome.true_places = WithTrueJoins(TruePlaces(poses), flat, truth);
  return outcome;
}

}  // namespace bulletnav::bench
