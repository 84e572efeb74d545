// SPDX-License-Identifier: MIT
#include "agent/perception/semantic_net.h"

#include "agent/perception/model_file.h"
#include "agent/perception/weights.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::agent {

SemanticNet::SemanticNet(const ModelConfig& config, std::uint64_t seed) : config_(config) {
  sim::Rng rng(seed, "semantic_net");
  encoder_ = register_module("encoder", std::make_shared<Encoder>(config, &rng));
  heads_ = register_module("heads", std::make_shared<Heads>(config, &rng));
}

PanoramaParts SemanticNet::Describe(const torch::Tensor& input,
                                    std::optional<at::Generator> dropout) {
  return heads_->Describe(encoder_->forward(input, std::move(dropout)));
}

PairOutputs SemanticNet::Compare(const PanoramaParts& sources, const PanoramaParts& goals) {
  return heads_->Compare(sources, goals);
}

void SemanticNet::Fold() {
  encoder_->Fold(ComputeType(config_));
}

void SaveNet(const SemanticNet& net, std::map<std::string, std::string> notes, StoredType type,
             const std::filesystem::path& file) {
  notes[kModelKey] = sim::ToYaml(net.config());
  SaveWeights(net, std::move(notes), type, file);
}

std::shared_ptr<SemanticNet> LoadNet(const std::filesystem::path& file) {
  const TensorFile content = ReadTensorFile(file);
  auto net = std::make_shared<SemanticNet>(ModelConfigOf(content, file), 0);
  SetWeights(content, "", file, net.get());
  return net;
}

void TakeNet(const std::filesystem::path& file, SemanticNet* net) {
  const TensorFile content = ReadTensorFile(file);
  ModelConfig theirs = ModelConfigOf(content, file);
  theirs.dropout = net->config().dropout;
  theirs.precision = net->config().precision;
  theirs.norm = net->config().norm;
  if (theirs != net->config()) throw OtherShape(file, kModelKey);
  SetWeights(content, "", file, net);
}

}  // namespace bulletnav::agent
