// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "agent/models/safetensors.h"
#include "agent/observation.h"
#include "agent/perception/mapper_config.h"
#include "agent/perception/model_config.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

/// Where the metadata of a file of weights hold the configuration of a semantic model or of a
/// mapper, as YAML.
inline constexpr const char* kModelKey = "model";
inline constexpr const char* kMapperKey = "mapper";

/// The configuration that the weights belong to; `file` is named in errors. Throws FileError if it
/// is missing or bad.
ModelConfig ModelConfigOf(const TensorFile& weights, const std::filesystem::path& file);
MapperConfig MapperConfigOf(const TensorFile& weights, const std::filesystem::path& file);

/// What to throw where weights are to be trained on in a net of another shape; `key` holds theirs.
sim::FileError OtherShape(const std::filesystem::path& file, const std::string& key);

/// Throws Error unless a rig gives what the model takes: 128 x 512 panoramas with colour and, by
/// its configuration, depth.
void RequireRig(const Rig& rig, const ModelConfig& config, const std::filesystem::path& file);

}  // namespace bulletnav::agent
