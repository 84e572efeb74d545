// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/torch.h"

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
    torch::Tensor log_probabilities;  // [steps, lanes, actions]
    torch::Tensor values;             // [steps, lanes], normalised
    torch::Tensor hidden;             // [lanes, width], after the last step
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
};

}  // namespace bulletnav::bench
