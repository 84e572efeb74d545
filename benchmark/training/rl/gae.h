// SPDX-License-Identifier: MIT
#pragma once
#include <span>

namespace bulletnav::bench {

/// What came of one step of one lane, as a learner keeps it.
struct LaneStep {
  double reward = 0.0;
  double value = 0.0;       // of the state it was taken in, in units of reward
  bool terminated = false;  // the episode ended here: nothing more is to be had
  bool truncated = false;   // it was cut here: more would have been to be had,
  double cut_value = 0.0;   // this much
};

struct GaeSpec {
  double discount = 0.99;  // gamma
  double lambda = 0.95;

  template <class V>
  void Visit(V& v) {
    v("discount", discount);
    v("lambda", lambda);
  }
  /// Throws Error unless both lie in [0, 1].
  void Validate() const;
};

/// Advantages of the steps of one lane, in their order; an advantage and the step's value make its
/// return. `last_value`: of the state after the last step, unless an episode ended there. Nothing
/// leaks from one episode into the one before. Expects: sizes that agree (checked).
/// Source: Schulman et al., "High-dimensional continuous control using generalized advantage
/// estimation", 2015, equation 16; cuts: Pardo et al., "Time limits in reinforcement learning",
/// 2018.
void EstimateAdvantages(const GaeSpec& spec, std::span<const LaneStep> steps, double last_value,
                        std::span<double> advantages);

}  // namespace bulletnav::bench
