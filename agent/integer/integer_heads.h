// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "agent/integer/dot_layer.h"
#include "agent/models/semantic_model.h"

namespace bulletnav::agent {

/// Two fully connected layers with ReLU between, one answer: a logit. Layers NAME_hidden and
/// NAME_out, scale NAME_hidden.
class IntegerAnswer {
 public:
  IntegerAnswer(const QuantisedNet& net, const std::string& name, const LayerScales& in);

  /// Answers for pixels of 16-bit inputs, `in_offsets` bytes from `in`; a logit each.
  void Run(const std::int16_t* in, std::span<const std::int32_t> in_offsets,
           std::span<std::int32_t> logits);
  void Use(const IntegerKernels& kernels);

 private:
  DotLayer hidden_;
  std::vector<std::int16_t> weights_;  // of the answer
  std::int64_t bias_;
  std::int64_t factor_;  // logits for a sum, in units of 2^-kAnswerBits
  std::vector<std::int16_t> values_;
};

/// What is compared of a panorama, numbers of 16 bits but for logits.
struct IntegerParts {
  std::array<std::int32_t, kDirections> explorable{};  // logits
  std::vector<std::int16_t> source_sum;                // [kDirections, features]
  std::vector<std::int16_t> goal_sum;                  // likewise
  std::vector<std::int16_t> source_match;              // [kDirections, kMatches * kMatchSize]
  std::vector<std::int16_t> goal_match;                // likewise
};

/// The heads of a semantic model in integers; see Heads, whose layers it has by the same names,
/// after "heads.". Not for several threads at once.
class IntegerHeads {
 public:
  static constexpr int kMatches = 4;
  static constexpr int kMatchSize = 32;

  /// `code_scale`: real value of one step of codes, of `code_size` numbers. Throws Error if layers
  /// are missing or do not fit.
  IntegerHeads(const QuantisedNet& net, int code_size, double code_scale);

  int features() const { return second_.padded_outputs(); }
  /// Of codes [kDirections, code_size].
  IntegerParts Describe(std::span<const std::int16_t> codes);
  /// What Compare needs of a goal.
  void SetGoal(const IntegerParts& goal);
  /// The source, and the goal that was set.
  PairPrediction Compare(const IntegerParts& source);

  void Use(const IntegerKernels& kernels);

 private:
  void MatchWithGoal(const IntegerParts& source);
  void SumTurns(const IntegerParts& source);
  void GatherTurns();
  PairPrediction Answer();

  int code_size_;
  IntegerAnswer explorable_;
  DotLayer source_sum_;
  DotLayer goal_sum_;
  DotLayer source_match_;
  DotLayer goal_match_;
  std::int64_t product_factor_;
  DotLayer matches_;
  DotLayer second_;
  IntegerAnswer direction_;
  IntegerAnswer score_;
  IntegerAnswer connection_;
  IntegerAnswer distance_;
  const IntegerKernels* kernels_;

  // Where pairs [i, r] and directions lie; see SumTurns.
  std::vector<std::int32_t> torus_offsets_;
  std::vector<std::int32_t> source_offsets_;
  std::vector<std::int32_t> goal_offsets_;
  std::vector<std::int32_t> pair_offsets_;
  std::vector<std::int32_t> direction_offsets_;
  AlignedVector<std::int32_t> goal_words_;  // the goal's matches as weights, [kMatches, 16, block]
  std::vector<std::int16_t> goal_sums_;     // of the goal
  std::vector<std::int32_t> products_;      // [kMatches, kDirections, block]
  std::vector<std::uint8_t> torus_;         // [kTorusRows, kTorusCols, kMatches]
  std::vector<std::uint8_t> sums_;          // [i, r, features]
  std::vector<std::uint8_t> both_;          // likewise
  std::vector<std::int16_t> directions_;    // [i, 2 * features]
  std::vector<std::int16_t> whole_;         // [4 * features]
};

}  // namespace bulletnav::agent
