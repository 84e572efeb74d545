// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "agent/policy/policy_net.h"

namespace bulletnav::agent {

/// The same panoramas, u8 [n, picture_bytes()], as each encoder was trained to be shown them: one
/// of colour alone without depth.
struct StitchPictures {
  torch::Tensor of_policy;
  torch::Tensor of_other;
};

/// Lets a trained policy see with another encoder in integers, as one of colour instead of one of
/// colour and depth: the codes that it knows are replaced by the linear function of the other's
/// codes that comes nearest to them, the same for all patches, which goes into the layers that read
/// codes. The function is fitted by least squares. Returns the share of the codes' variance that it
/// explains. Throws Error if there are fewer pictures than a code has numbers. Source: Bansal,
/// Nakkiran and Barak, "Revisiting model stitching to compare neural representations", NeurIPS
/// 2021.
double StitchPolicy(const StitchPictures& pictures, std::shared_ptr<IntegerSight> other,
                    PolicyNet* policy);

}  // namespace bulletnav::agent
