// SPDX-License-Identifier: MIT
#pragma once
#include <torch/torch.h>

namespace bulletnav::agent {

/// A GRU over a sequence of steps. Its gradients are worked out by hand: that of the weight is one
/// product for all steps together, where it would else be made, and added up, for each. They cannot
/// be differentiated again.
/// `inputs` [steps, lanes, 3 * size]: W x + b for the reset gate, the update gate and what is new,
/// in this order; `starts` [steps, lanes]: 1 where the memory is forgotten before the step;
/// `memory` [lanes, size] before the first step; `weight` [3 * size, size] and `bias` [3 * size] of
/// the memory. Gives the memory after each step, [steps, lanes, size].
/// Source: Cho et al., "Learning phrase representations using RNN encoder-decoder", 2014, with the
/// reset gate after the product, as torch.nn.GRU.
torch::Tensor RunGru(const torch::Tensor& inputs, const torch::Tensor& starts,
                     const torch::Tensor& memory, const torch::Tensor& weight,
                     const torch::Tensor& bias);

}  // namespace bulletnav::agent
