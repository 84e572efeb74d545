// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "agent/integer/quantised_layer.h"
#include "agent/models/safetensors.h"
#include "agent/policy/policy_config.h"

namespace bulletnav::agent {

/// A trained policy's file keeps each number once: layers that have 16 bits in integers are not
/// kept beside them as they were trained, since RestorePolicy makes them again, to within half a
/// step of each row's scale: some 2000th of its largest weight, about as close as bfloat16.

/// What each column of the layer "joined" is multiplied by before it is put in integers, [parts]:
/// all its inputs come in steps of the scale "whole". Throws Error if the net lacks scales.
std::vector<float> JoinedFactors(const PolicyConfig& config, const QuantisedNet& net);

/// Names of the trained numbers that RestorePolicy makes of this net.
std::vector<std::string> RestoredNumbers(const QuantisedNet& net);

/// Adds the trained numbers that `weights`, of a policy of this shape, holds in integers alone.
/// Throws FileError naming `file` if the integers are not whole.
void RestorePolicy(const PolicyConfig& config, const std::filesystem::path& file,
                   TensorFile* weights);

}  // namespace bulletnav::agent
