// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "agent/models/safetensors.h"
#include "agent/observation.h"
#include "agent/policy/policy_config.h"

namespace bulletnav::agent {

/// What is to be done about a file whose integers cannot be used.
inline constexpr const char* kTrainPolicyAgain = "train the policy again";

/// A note in the metadata of weights that see with another encoder than they were trained with.
inline constexpr const char* kStitchedKey = "stitched";

/// The setting of the training that made the weights, "rgb", "rgbd" or "both", as its config in the
/// metadata says; empty if that does not say, or is not of the encoder that is in the file now.
std::string TrainedSetting(const TensorFile& weights, const std::filesystem::path& file);

/// The configuration of the policy that weights belong to. Throws FileError if it is missing or
/// bad.
PolicyConfig PolicyConfigOf(const TensorFile& weights, const std::filesystem::path& file);

/// Throws FileError if the weights know one setting alone, and another one than `setting`, "rgb" or
/// "rgbd".
void RequireTrainedSetting(const std::string& setting, const TensorFile& weights,
                           const std::filesystem::path& file);

/// Throws FileError unless a rig is the body that the policy was trained in: the default one, which
/// sees cylindrical panoramas of 128 x 512 with colour, and depth or none as in the setting of its
/// training. Weights that do not tell their setting, and those with another encoder stitched
/// in, may have depth or not, but for those of a map.
void RequirePolicyRig(const Rig& rig, const TensorFile& weights, const std::filesystem::path& file);

}  // namespace bulletnav::agent
