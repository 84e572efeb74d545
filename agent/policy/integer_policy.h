// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "agent/integer/dot_layer.h"
#include "agent/policy/integer_map.h"
#include "agent/policy/integer_sight.h"
#include "agent/policy/policy_config.h"
#include "agent/policy/policy_input.h"
#include "agent/policy/policy_model.h"

namespace bulletnav::agent {

/// How the numbers of a policy in integers are kept; see IntegerPolicy. Layers are named as those
/// of PolicyNet.
inline constexpr int kPolicyLargest = 4095;              // of values that feed layers of 16 bits
inline constexpr double kPolicyNumberStep = 1.0 / 1024;  // of WritePolicyNumbers
inline constexpr double kPolicyLogitStep = 1.0 / 1024;   // of gates and answers, within 32
inline constexpr double kPolicyMemoryStep = 1.0 / kPolicyLargest;  // as it feeds layers
inline constexpr int kPolicyMatches = 4;
inline constexpr int kPolicyMatchSize = 32;
/// Real value of a step of products of two values of this step.
constexpr double PolicyProductStep(double step) {
  return step * step * (kPolicyLargest + 1);
}

/// A policy in integers: what PolicyNet says, from bytes to probabilities, the same on every
/// processor. The memory between steps is kept in units of 2^-20, as floats that hold it exactly.
/// Not for several threads at once.
class IntegerPolicy final : public PolicyModel {
 public:
  /// Throws Error if layers or scales are missing or do not fit the configuration.
  IntegerPolicy(const PolicyConfig& config, const QuantisedNet& net);

  int step_limit() const override { return config_.step_limit; }
  bool sees_map() const override { return map_.has_value(); }
  std::vector<float> NoMemory() const override;
  std::vector<float> CodeOf(const Panorama& goal) override;
  std::array<float, 4> Act(const PolicyQuestion& question, std::vector<float>* memory) override;

  /// Instead of the fastest kernels, for tests; not of the encoder.
  void Use(const IntegerKernels& kernels);

 private:
  using Values = std::vector<std::int16_t>;

  IntegerEncoder::Codes See(const Panorama& panorama);
  Values Matches(DotLayer* layer, const IntegerEncoder::Codes& codes) const;
  void Correlate(const Values& source, std::span<const float> goal, std::int16_t* out) const;
  void Join(const IntegerEncoder::Codes& codes, const PolicyQuestion& question);
  void Remember(std::vector<float>* memory);

  PolicyConfig config_;
  IntegerSight sight_;
  PolicyPictures pictures_;
  std::vector<std::uint8_t> bytes_;
  DotLayer whole_;
  std::optional<DotLayer> source_match_;
  std::optional<DotLayer> goal_match_;
  std::optional<DotLayer> matches_;
  std::optional<IntegerMap> map_;
  DotLayer joined_;
  DotLayer gru_in_;
  DotLayer gru_memory_;
  DotLayer head_;
  std::int64_t correlation_factor_ = 0;  // in units of 2^-kCorrelationBits

  Values parts_;   // inputs of joined_
  Values inside_;  // its outputs
  Values in_;      // of gates, from what is seen
  Values kept_;    // and from memory
  Values state_;   // memory as it feeds layers
};

}  // namespace bulletnav::agent
