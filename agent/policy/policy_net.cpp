// SPDX-License-Identifier: MIT
#include "agent/policy/policy_net.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/models/semantic_model.h"
#include "agent/perception/model_file.h"
#include "agent/perception/weights.h"
#include "agent/policy/gru.h"
#include "agent/policy/integer_policy.h"
#include "agent/policy/policy_file.h"
#include "agent/policy/policy_input.h"
#include "agent/policy/restore_policy.h"
#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::agent {
namespace {

constexpr int kMatches = kPolicyMatches;
constexpr int kMatchSize = kPolicyMatchSize;
constexpr int kTurns = kMatches * kDirections * kDirections;
constexpr int kActions = 4;
constexpr double kPolicyGain = 0.01;
constexpr double kMemoryGain = 0.7;  // variance 1 / inputs
constexpr double kStopAtFirst = 0.02;
constexpr const char* kMap = "map";
constexpr const char* kJoined = "joined";
constexpr const char* kEncoder = "encoder.";
constexpr const char* kStem = "encoder.trunk.stem.weight";

constexpr float kMiddle = 127.0f;  // see IntegerInput and PrepareInput
constexpr float kColorStep = 2.0f / 127.0f;
constexpr float kDepthStep = 1.0f / 127.0f;

/// Entry i * 12 + r is i * 12 + (i + r) mod 12: the goal's codes turned by r.
torch::Tensor Turns() {
  std::vector<std::int64_t> indices;
  for (int i = 0; i < kDirections; ++i) {
    for (int r = 0; r < kDirections; ++r)
      indices.push_back(i * kDirections + (i + r) % kDirections);
  }
  return torch::tensor(indices, torch::kInt64);
}

/// Puts those of the policy's own weights whose names start so among others'.
void KeepOwn(const PolicyNet& net, const std::string& prefix, TensorFile* weights) {
  TensorFile own;
  AppendWeights(net, "", &own);
  for (const auto& [name, tensor] : own.tensors) {
    if (name.starts_with(prefix)) weights->tensors[name] = tensor;
  }
}

/// Weights of a policy that is shown no map, as those of one that is: its own branch for the map,
/// to which the layer after it does not listen yet.
void AddMap(const PolicyNet& net, TensorFile* weights) {
  KeepOwn(net, kMap + std::string("."), weights);
  const auto joined = weights->tensors.find(kJoined + std::string(".weight"));
  if (joined == weights->tensors.end()) return;  // SetWeights complains
  const torch::Tensor narrow = FromStored(joined->second);
  joined->second = ToStored(at::cat({narrow, torch::zeros({narrow.size(0), kMapFeatures})}, 1));
}

/// Leaves out another policy's encoder in floats; `net` keeps its own, if it has one.
void KeepEncoder(const PolicyNet& net, TensorFile* weights) {
  std::erase_if(weights->tensors, [](const auto& tensor) {
    return tensor.first.starts_with(kEncoder);
  });
  KeepOwn(net, kEncoder, weights);
}

/// A stem that reads colour alone, as one that is given depth, too, and does not heed it.
void AddDepth(const std::filesystem::path& file, TensorFile* weights) {
  const auto stem = weights->tensors.find(kStem);
  if (stem == weights->tensors.end() || stem->second.shape.size() != 4) {
    throw sim::FileError(file, kStem, "is missing: these are weights of another model");
  }
  const torch::Tensor color = FromStored(stem->second);
  stem->second = ToStored(at::cat({color, torch::zeros_like(color.narrow(1, 0, 1))}, 1));
}

}  // namespace

torch::Tensor PolicyInput(const PolicyConfig& config, const torch::Tensor& pictures) {
  const std::int64_t rows = config.rows;
  const torch::Tensor steps = torch::tensor({kColorStep, kColorStep, kColorStep, kDepthStep});
  return pictures.narrow(1, 0, 16 * rows * rows)
      .reshape({-1, rows, 4 * rows, 4})
      .to(torch::kFloat32)
      .sub_(kMiddle)
      .mul_(steps)
      .permute({0, 3, 1, 2});
}

PolicyNet::PolicyNet(const PolicyConfig& config, std::uint64_t seed) : config_(config) {
  sim::Rng rng(seed, "policy_net");
  const auto add = [&](const char* name, int in, int out, double gain = 1.0) {
    return register_module(name, std::make_shared<Dense>(in, out, &rng, gain));
  };
  const int features = config.features;
  if (config.own_encoder) {
    encoder_ = register_module("encoder", std::make_shared<Encoder>(config.seeing(), &rng));
  }
  whole_ = add("whole", kCodes, features);
  int parts = 3 * features + kPolicyNumbers;
  if (config.fusion == Fusion::kCorrelation) {
    source_match_ = add("source_match", kCodeSize, kMatches * kMatchSize);
    goal_match_ = add("goal_match", kCodeSize, kMatches * kMatchSize);
    matches_ = add("matches", kTurns, features);
    parts += features;
  }
  if (config.map) {
    map_ = register_module(kMap, std::make_shared<MapBranch>(&rng));
    parts += kMapFeatures;
  }
  joined_ = add(kJoined, parts, features);
  gru_in_ = add("gru_in", features, 3 * config.memory, kMemoryGain);
  gru_memory_ = add("gru_memory", config.memory, 3 * config.memory, kMemoryGain);
  policy_ = add("policy_head", config.memory, kActions, kPolicyGain);
  value_ = add("value_head", config.memory, 1, kMemoryGain);
  const torch::NoGradGuard no_grad;
  const double stop = sim::Log(kStopAtFirst / ((1.0 - kStopAtFirst) / (kActions - 1)));
  policy_->named_parameters()["bias"][0] = stop;
}

void PolicyNet::SeeWith(std::shared_ptr<IntegerSight> sight) {
  BULLETNAV_CHECK_EQ(sight->code_size(), kCodes);
  sight_ = std::move(sight);
}

std::int64_t PolicyNet::PictureBytes(const PolicyConfig& config) {
  return 16 * std::int64_t{config.rows} * config.rows +
         (config.map ? std::int64_t{kPolicyMapBytes} : 0);
}

std::int64_t PolicyNet::CodeSize(const PolicyConfig& config) {
  return kCodes + (config.map ? std::int64_t{kPolicyMapBytes} : 0);
}

torch::Tensor PolicyNet::EncodeInIntegers(const torch::Tensor& pictures) const {
  const std::int64_t rows = config_.rows;
  const torch::Tensor bytes = pictures.narrow(1, 0, 16 * rows * rows).contiguous();
  const IntegerEncoder::Codes codes =
      sight_->Codes({bytes.data_ptr<std::uint8_t>(), static_cast<std::size_t>(bytes.numel())});
  torch::Tensor numbers = torch::empty({pictures.size(0), kCodes});
  const auto step = static_cast<float>(sight_->code_step());
  std::transform(codes.begin(), codes.end(), numbers.data_ptr<float>(), [step](std::int16_t code) {
    return step * static_cast<float>(code);
  });
  return numbers;
}

torch::Tensor PolicyNet::Encode(const torch::Tensor& pictures) {
  const torch::Tensor codes =
      sight_ ? EncodeInIntegers(pictures)
             : encoder_->forward(PolicyInput(config_, pictures)).view({-1, kCodes});
  if (!map_) return codes;
  const std::int64_t bytes = kPolicyMapBytes;
  return at::cat({codes, pictures.narrow(1, pictures.size(1) - bytes, bytes).to(torch::kFloat32)},
                 1);
}

torch::Tensor PolicyNet::Correlation(const torch::Tensor& codes, const torch::Tensor& goals) {
  const auto split = [](const torch::Tensor& x) {
    return x.reshape({-1, kDirections, kMatches, kMatchSize}).transpose(1, 2);
  };
  const torch::Tensor sources =
      split(source_match_->forward(codes.reshape({-1, kDirections, kCodeSize})));
  const torch::Tensor others =
      split(goal_match_->forward(goals.reshape({-1, kDirections, kCodeSize})));
  static const torch::Tensor turns = Turns();
  return (at::matmul(sources, others.transpose(2, 3)) / std::sqrt(double{kMatchSize}))
      .reshape({-1, kMatches, kDirections * kDirections})
      .index_select(2, turns)
      .reshape({-1, kTurns});
}

torch::Tensor PolicyNet::Joined(const Seen& seen) {
  const std::int64_t count = seen.codes.size(0) * seen.codes.size(1);
  const torch::Tensor shown = seen.codes.reshape({count, code_size()});
  const torch::Tensor codes = shown.narrow(1, 0, kCodes);
  const torch::Tensor goals = seen.goals.narrow(-1, 0, kCodes).reshape({count, kCodes});
  const torch::Tensor here = whole_->forward(codes).relu();
  const torch::Tensor there = whole_->forward(goals).relu();
  std::vector<torch::Tensor> parts = {here, there, here * there,
                                      seen.numbers.reshape({count, kPolicyNumbers})};
  if (matches_) parts.push_back(matches_->forward(Correlation(codes, goals)).relu());
  if (map_) parts.push_back(map_->forward(shown.narrow(1, kCodes, code_size() - kCodes)));
  return joined_->forward(at::cat(parts, 1))
      .relu()
      .view({seen.codes.size(0), seen.codes.size(1), config_.features});
}

PolicyNet::Output PolicyNet::Run(const Seen& seen, const torch::Tensor& starts,
                                 const torch::Tensor& memory) {
  const auto of_memory = gru_memory_->named_parameters();
  const torch::Tensor states = RunGru(gru_in_->forward(Joined(seen)), starts, memory,
                                      of_memory["weight"], of_memory["bias"]);
  return {policy_->forward(states), value_->forward(states).squeeze(-1), states[-1]};
}

void PolicyNet::Fold() {
  if (encoder_) encoder_->Fold(ComputeType(config_.seeing()));
}

void SavePolicy(const PolicyNet& net, std::map<std::string, std::string> notes, StoredType type,
                const std::filesystem::path& file) {
  TensorFile content;
  content.metadata = std::move(notes);
  content.metadata[kPolicyKey] = sim::ToYaml(net.config());
  AppendWeights(net, "", &content);
  if (net.sight()) {
    SetQuantised(net.sight()->net(), &content);
    content.metadata[kIntegerPart] = "encoder";
  }
  WriteTensorFile(file, content, type);
}

std::shared_ptr<PolicyNet> LoadPolicy(const std::filesystem::path& file) {
  TensorFile content = ReadTensorFile(file);
  const PolicyConfig config = PolicyConfigOf(content, file);
  RestorePolicy(config, file, &content);
  auto net = std::make_shared<PolicyNet>(config, 0);
  SetWeights(content, "", file, net.get());
  if (!net->config().own_encoder) TakeIntegerEncoder(file, net.get());
  return net;
}

void TakePolicy(const std::filesystem::path& weights, PolicyNet* net) {
  TensorFile content = ReadTensorFile(weights);
  const PolicyConfig theirs = PolicyConfigOf(content, weights);
  RestorePolicy(theirs, weights, &content);
  if (net->config().map && !theirs.map) AddMap(*net, &content);
  if (net->config().own_encoder != theirs.own_encoder) KeepEncoder(*net, &content);
  SetWeights(content, "", weights, net);
  if (!net->sight()) return;
  const IntegerSight sight(ReadQuantised(content, weights), theirs.rows);
  if (sight.net() != net->sight()->net()) {
    throw sim::FileError(weights, kIntegerPrefix,
                         "holds another encoder than the one to see with; name this file as the "
                         "encoder, too: encoder: " +
                             weights.string());
  }
}

torch::Tensor WithoutDepth(const torch::Tensor& pictures) {
  torch::Tensor color = pictures.clone();
  color.view({color.size(0), -1, kInputChannels}).select(2, kInputChannels - 1).zero_();
  return color;
}

std::shared_ptr<IntegerSight> LoadSight(const std::filesystem::path& weights, int rows) {
  const TensorFile content = ReadTensorFile(weights);
  if (!HoldsIntegers(content) && !content.metadata.contains(kIntegerPart)) {
    throw sim::FileError(weights, kIntegerPrefix,
                         "is missing: there is no encoder in integers; quantise the weights");
  }
  try {
    return std::make_shared<IntegerSight>(ReadQuantised(content, weights), rows);
  } catch (const sim::FileError&) {
    throw;
  } catch (const sim::Error& error) {
    throw sim::FileError(weights, kIntegerPrefix,
                         std::string("has no encoder for this policy: ") + error.what());
  }
}

void TakeIntegerEncoder(const std::filesystem::path& weights, PolicyNet* net) {
  net->SeeWith(LoadSight(weights, net->config().rows));
}

void TakeEncoder(const std::filesystem::path& weights, PolicyNet* net) {
  const TensorFile content = ReadTensorFile(weights);
  const ModelConfig theirs = ModelConfigOf(content, weights);
  const ModelConfig own = net->config().seeing();
  if (theirs.encoder != own.encoder || theirs.depth == DepthFusion::kSeparate ||
      theirs.width != own.width || theirs.rows != own.rows) {
    throw sim::FileError(weights, "",
                         "has an encoder of another shape than the policy: it needs form panorama, "
                         "depth as a channel or none, and the policy's width and rows");
  }
  TensorFile encoder;
  for (const auto& [name, tensor] : content.tensors) {
    if (name.starts_with(kEncoder)) encoder.tensors[name] = tensor;
  }
  if (!theirs.uses_depth()) AddDepth(weights, &encoder);
  SetWeights(encoder, kEncoder, weights, net->named_children()["encoder"].get());
}

}  // namespace bulletnav::agent
