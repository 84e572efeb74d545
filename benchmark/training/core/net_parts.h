// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/torch.h"

namespace bulletnav::bench {

/// Work on a net is shared out to others of its form, so that several threads have gradients of
/// their own. `part` gets the parameters of `net`, which must stay where they are.
void ShareParameters(const torch::nn::Module& net, const torch::nn::Module& part);

/// Adds `share` times the gradients of `part` to those of `net`; `part` has none after that.
void TakeGradients(const torch::nn::Module& part, double share, const torch::nn::Module& net);

}  // namespace bulletnav::bench
