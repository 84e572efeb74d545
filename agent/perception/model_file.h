// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "agent/observation.h"
#include "agent/perception/model_config.h"
#include "agent/perception/safetensors.h"

namespace bulletnav::agent {

/// Where the metadata of a file of weights hold the model's configuration, as YAML.
inline constexpr const char* kModelKey = "model";

/// The configuration that the weights belong to; `file` is named in errors. Throws FileError if it
/// is missing or bad.
ModelConfig ModelConfigOf(const TensorFile& weights, const std::filesystem::path& file);

/// Throws Error unless a rig gives what the model takes: 128 x 512 panoramas with colour and, by
/// its configuration, depth.
void RequireRig(const Rig& rig, const ModelConfig& config, const std::filesystem::path& file);

}  // namespace bulletnav::agent
