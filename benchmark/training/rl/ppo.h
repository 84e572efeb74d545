// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "benchmark/training/core/optimiser.h"
#include "benchmark/training/rl/lane_groups.h"
#include "benchmark/training/rl/rollout.h"

namespace bulletnav::bench {

/// Proximal policy optimisation. Sources: Schulman et al., 2017; values of habitat-lab's
/// ddppo_imagenav_gibson.yaml, except that advantages and returns are normalised here.
struct PpoSpec {
  int lanes = 32;
  int group = 4;     // lanes that are asked and learned from together
  int rollout = 64;  // steps of each lane between updates
  int epochs = 2;
  int minibatches = 2;  // each of whole groups
  double clip = 0.2;
  double entropy = 0.01;
  double value = 0.5;
  double gradient_norm = 0.2;
  /// Rollouts at the beginning from which the value alone is learned: a policy that begins with the
  /// weights of an imitator would else be spoilt by values that know nothing yet. The
  /// rate's warm-up begins again with the policy's learning.
  int value_first = 0;
  GaeSpec gae;

  template <class V>
  void Visit(V& v) {
    v("lanes", lanes);
    v("group", group);
    v("rollout", rollout);
    v("epochs", epochs);
    v("minibatches", minibatches);
    v("clip", clip);
    v("entropy", entropy);
    v("value", value);
    v("gradient_norm", gradient_norm);
    v("value_first", value_first);
    v("gae", gae);
  }
  /// Throws Error.
  void Validate() const;
};

/// How an update went: means over its minibatches.
struct PpoReport {
  double loss = 0.0;
  double entropy = 0.0;
  double kl = 0.0;                 // from the policy that acted
  double clip_fraction = 0.0;      // of steps whose ratio is out of bounds
  double first_ratio_error = 0.0;  // mean |ratio - 1| of the first minibatch: rounding alone
  double first_clip_fraction = 0.0;
  double explained_variance = 0.0;  // of the returns, by the values before the update
};

/// What an update works with beside the rollout.
struct PpoStep {
  Optimiser* optimiser = nullptr;
  double rate = 0.0;
  std::uint64_t seed = 0;    // of the order of groups
  bool value_alone = false;  // see PpoSpec::value_first
};

/// Learns from a rollout: minibatches of whole groups, each played again from its hidden state.
/// `groups`: of `net`. `moments`: of returns; takes in this rollout's.
PpoReport LearnFrom(const Rollout& rollout, const PpoSpec& spec, const PpoStep& step,
                    LaneGroups* groups, ActorCritic* net, RunningMoments* moments);

}  // namespace bulletnav::bench
