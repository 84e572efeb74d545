// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "agent/models/safetensors.h"
#include "agent/perception/encoder.h"
#include "agent/perception/heads.h"

namespace bulletnav::agent {

/// The multi-task model of Neural Topological SLAM: an encoder and heads. The same configuration
/// and seed give the same weights on every machine.
class SemanticNet : public torch::nn::Module {
 public:
  SemanticNet(const ModelConfig& config, std::uint64_t seed);

  const ModelConfig& config() const { return config_; }
  /// `input` is of PrepareInput; dropout only with a generator.
  PanoramaParts Describe(const torch::Tensor& input, std::optional<at::Generator> dropout = {});
  PairOutputs Compare(const PanoramaParts& sources, const PanoramaParts& goals);
  /// For inference only: see ConvNorm::Fold.
  void Fold();

 private:
  ModelConfig config_;
  std::shared_ptr<Encoder> encoder_;
  std::shared_ptr<Heads> heads_;
};

/// A file of weights holds the configuration as YAML in its metadata under "model".
void SaveNet(const SemanticNet& net, std::map<std::string, std::string> notes, StoredType type,
             const std::filesystem::path& file);
/// Throws FileError, also if the configuration is missing or bad.
std::shared_ptr<SemanticNet> LoadNet(const std::filesystem::path& file);
/// Gives a net the weights of a file, to be trained on from there. Throws FileError, also if they
/// are of a net of another shape.
void TakeNet(const std::filesystem::path& file, SemanticNet* net);

}  // namespace bulletnav::agent
