// SPDX-License-Identifier: MIT
#pragma once
#include "agent/integer/quantised_layer.h"
#include "agent/policy/policy_net.h"

namespace bulletnav::agent {

/// What scales are made from: steps of a policy in the world.
struct PolicyCalibration {
  torch::Tensor pictures;       // u8 [m, bytes], from which an encoder of its own is quantised
  torch::Tensor goal_pictures;  // u8 [m, bytes], of their goals
  torch::Tensor numbers;        // [m, kPolicyNumbers]
};

/// The policy in integers that a trained one becomes; see IntegerPolicy. Throws Error for a width
/// that is no multiple of 16.
QuantisedNet Quantise(PolicyNet* net, const PolicyCalibration& calibration);

}  // namespace bulletnav::agent
