// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "agent/models/safetensors.h"
#include "agent/observation.h"
#include "agent/policy/policy_config.h"

namespace bulletnav::agent {

/// What is to be done about a file whose integers cannot be used.
inline constexpr const char* kTrainPolicyAgain = "train the policy again";

/// The configuration of the policy that weights belong to. Throws FileError if it is missing or
/// bad.
PolicyConfig PolicyConfigOf(const TensorFile& weights, const std::filesystem::path& file);

/// Throws FileError unless a rig gives what the policy takes: panoramas of 128 x 512 with colour
/// and, if it is shown a map, depth.
void RequirePolicyRig(const Rig& rig, const PolicyConfig& config,
                      const std::filesystem::path& file);

}  // namespace bulletnav::agent
