// SPDX-License-Identifier: MIT
#pragma once
#include "agent/integer/quantised_layer.h"
#include "agent/perception/mapper_net.h"
#include "agent/perception/semantic_net.h"

namespace bulletnav::agent {

/// Whether there are networks in integers of this form: not of kPatches, of depth kSeparate, or of
/// widths that are no multiple of 16.
bool HasIntegerForm(const ModelConfig& config);
bool HasIntegerForm(const MapperConfig& config);

class Quantiser;

/// The layers and scales of an encoder of form kPanorama, whose parameters are named after
/// `prefix`; see IntegerEncoder. Returns what it makes of `input`, [n, channels, rows, cols] of
/// PrepareInput.
torch::Tensor QuantiseEncoder(const std::string& prefix, const torch::Tensor& input,
                              Quantiser* quantiser);

/// The network in integers that a trained one becomes; see IntegerModel. Scales are from what it
/// makes of `input`, [n, channels, rows, cols] of PrepareInput, n >= 2: each panorama and pairs of
/// each with the next. Throws Error for a form that there is none of.
QuantisedNet Quantise(const SemanticNet& net, const torch::Tensor& input);
/// Likewise, of a mapper; see IntegerMapper.
QuantisedNet Quantise(const MapperNet& net, const torch::Tensor& input);

}  // namespace bulletnav::agent
