// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "agent/perception/torch.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

/// A recurrent policy with a value: what PPO and imitation train. Tasks show it numbers and, if
/// they have them, pictures: of what is seen in each step, and of the goal, one an episode.
class ActorCritic : public torch::nn::Module {
 public:
  struct Seen {
    torch::Tensor numbers;     // [steps, lanes, size]
    torch::Tensor codes;       // [steps, lanes, code], of pictures; undefined where there are none
    torch::Tensor goal_codes;  // likewise
  };
  struct Output {
    /// [steps, lanes, actions]; or, of a policy that has a distribution of its own over actions,
    /// what that is given by.
    torch::Tensor log_probabilities;
    torch::Tensor values;  // [steps, lanes], normalised
    torch::Tensor hidden;  // [lanes, width], after the last step
  };

  /// Pictures u8 [n, bytes] to [n, code].
  virtual torch::Tensor Encode(const torch::Tensor& pictures) = 0;
  /// False: the encoder stays as it is, so that codes are kept instead of pictures.
  virtual bool learns_to_see() const = 0;
  /// `starts` [steps, lanes], 1 where an episode begins: the hidden state [lanes, width] that comes
  /// in is then zero.
  virtual Output Run(const Seen& seen, const torch::Tensor& starts,
                     const torch::Tensor& hidden) = 0;
  virtual torch::Tensor NoMemory(int lanes) const = 0;
  /// Whether a parameter of this name makes the value of what was made before, and nothing else.
  static bool IsOfValue(const std::string& name) { return name.find("value") != name.npos; }

  // The distribution of actions, by default the one of log_probabilities.

  /// An action, by what is said of one lane in one step.
  virtual int Draw(std::span<const float> log_probabilities, sim::Rng* rng) const;
  /// [steps, lanes] of actions [steps, lanes].
  virtual torch::Tensor LogProbabilitiesOf(const Output& output,
                                           const torch::Tensor& actions) const;
  virtual torch::Tensor EntropyOf(const Output& output) const;  // [steps, lanes]
};

}  // namespace bulletnav::bench
