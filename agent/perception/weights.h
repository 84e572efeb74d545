// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "agent/models/safetensors.h"
#include "agent/perception/torch.h"

namespace bulletnav::agent {

/// All parameters and running means of a net, by name, after `prefix`.
void AppendWeights(const torch::nn::Module& net, const std::string& prefix, TensorFile* content);

/// Sets them; `file` is named in errors. Throws FileError if one is missing or of another shape, if
/// one holds a number that is not finite, or if one too many starts with `prefix`.
void SetWeights(const TensorFile& content, const std::string& prefix,
                const std::filesystem::path& file, torch::nn::Module* net);

/// Writes a net's weights with `notes` as metadata.
void SaveWeights(const torch::nn::Module& net, std::map<std::string, std::string> notes,
                 StoredType type, const std::filesystem::path& file);

/// Between tensors of float32 and their stored form.
TensorFile::Tensor ToStored(const torch::Tensor& tensor);
torch::Tensor FromStored(const TensorFile::Tensor& stored);

}  // namespace bulletnav::agent
