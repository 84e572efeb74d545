// SPDX-License-Identifier: MIT
#pragma once
#include "agent/integer/quantised_layer.h"
#include "agent/perception/mapper_net.h"
#include "agent/perception/semantic_net.h"

namespace bulletnav::agent {

/// The network in integers that a trained one becomes; see IntegerModel. Scales are from what it
/// makes of `input`, [n, channels, rows, cols] of PrepareInput, n >= 2: each panorama and pairs of
/// each with the next. Throws Error for a model that there is none of: form kPatches, or depth
/// kSeparate.
QuantisedNet Quantise(const SemanticNet& net, const torch::Tensor& input);
/// Likewise, of a mapper; see IntegerMapper.
QuantisedNet Quantise(const MapperNet& net, const torch::Tensor& input);

}  // namespace bulletnav::agent
