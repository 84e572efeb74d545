// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "agent/integer/integer_input.h"
#include "agent/observation.h"
#include "sim/base/action.h"

namespace bulletnav::agent {

/// What a policy is told in numbers: the last action (one of four, none at the start), the motion
/// that was measured since (in steps and turns) and the share of the episode's steps that are gone.
inline constexpr int kPolicyNumbers = 8;

/// Of an observation and the action before it. Not whether the body collided: the paper's has no
/// bumper.
void WritePolicyNumbers(const Observation& observation, std::optional<sim::Action> last,
                        int step_limit, std::span<float> numbers);

/// Panoramas as policies see them, in training and after it: the bytes of IntegerInput, [rows,
/// cols, 4] red, green, blue and depth. A panorama without depth has 0 there, as if nothing
/// returned.
class PolicyPictures {
 public:
  /// Of panoramas of so many rows: means over squares of them.
  explicit PolicyPictures(int rows, int panorama_rows = kInputRows);

  std::size_t bytes() const { return static_cast<std::size_t>(pictures_.shape.size()); }
  /// Expects: a panorama of the right size (checked).
  void Write(const Panorama& panorama, std::span<std::uint8_t> out);

 private:
  IntegerInput with_depth_;
  IntegerInput color_alone_;
  Pictures pictures_;
};

}  // namespace bulletnav::agent
