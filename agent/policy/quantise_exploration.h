// SPDX-License-Identifier: MIT
#pragma once
#include "agent/integer/quantised_layer.h"
#include "agent/policy/exploration_net.h"

namespace bulletnav::agent {

/// The policy in integers that a trained one becomes; see IntegerExploration. Scales are from what
/// its layers come to on `views`, u8 [n, kExplorationBytes].
QuantisedNet Quantise(ExplorationNet* net, const torch::Tensor& views);

}  // namespace bulletnav::agent
