// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/seqnet_training.h"

#include <span>
#include <utility>

#include "agent/models/safetensors.h"
#include "agent/perception/one_thread.h"
#include "agent/perception/weights.h"
#include "benchmark/slam/training/seqvlad_net.h"
#include "sim/base/error.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

/// Numbers of a picture's descriptor, one for all walks.
int SizeOf(const std::vector<SequenceWalk>& walks) {
  for (const SequenceWalk& walk : walks) {
    if (!walk.descriptors.empty()) return static_cast<int>(walk.descriptors.front().size());
  }
  throw sim::Error("there is no walk to learn from");
}

}  // namespace

void SeqNetTrainConfig::Validate() const {
  SequencePlan::Validate();
  if (2 * model.length >= frames) {
    throw sim::KeyError("frames", "frames must be more than twice the model's length");
  }
}

SeqNetNet::SeqNetNet(const agent::SeqNetConfig& config, int size) {
  const torch::Tensor even = torch::eye(size) / config.length;
  filter_ = register_parameter("filter",
                               even.unsqueeze(1).expand({size, config.length, size}).contiguous());
  bias_ = register_parameter("bias", torch::zeros({size}));
}

torch::Tensor SeqNetNet::forward(const torch::Tensor& descriptors) const {
  return Directions(at::addmm(bias_, descriptors.flatten(1), filter_.flatten(1).t()));
}

void SaveSeqNet(const SeqNetNet& net, const agent::SeqNetConfig& config,
                std::map<std::string, std::string> notes, const std::filesystem::path& file) {
  agent::TensorFile content;
  notes[agent::kSeqNetKey] = sim::ToYaml(config);
  content.metadata = std::move(notes);
  agent::AppendWeights(net, "", &content);
  agent::WriteTensorFile(file, content, agent::StoredType::kBfloat16);
}

SeqNetTraining::SeqNetTraining(const Config& config, const TrainContext& context)
    : SeqNetTraining(config, MakeWalks(config, context)) {}

SeqNetTraining::SeqNetTraining(const Config& config, SequenceWalks walks)
    : SequenceTraining(config, {config.model.length, config.model.length}, std::string(kName),
                       std::move(walks)),
      config_(config),
      net_(config.model, SizeOf(SequenceTraining::walks().train)) {}

torch::Tensor SeqNetTraining::DescribeWindows(const SequenceWalk& walk,
                                              std::span<const Window> windows) {
  const auto size = static_cast<std::int64_t>(walk.descriptors.front().size());
  const int length = config_.model.length;
  const torch::Tensor all =
      torch::empty({static_cast<std::int64_t>(windows.size()), length, size}, torch::kInt16);
  auto* out = all.data_ptr<std::int16_t>();
  for (const Window& window : windows) {
    for (int i = window.first; i < window.first + length; ++i) {
      const agent::PictureDescriptor& one = walk.descriptors[static_cast<std::size_t>(i)];
      out = std::copy(one.begin(), one.end(), out);
    }
  }
  return net_.forward(all.to(torch::kFloat32) / agent::kDescriptorUnit);
}

void SeqNetTraining::SaveNet(std::map<std::string, std::string> notes,
                             const std::filesystem::path& file) const {
  SaveSeqNet(net_, config_.model, std::move(notes), file);
}

std::optional<Measures> SeqNetTraining::Quantise(const std::filesystem::path& file) {
  const auto filter = agent::LoadSeqNetFilter(file);
  return MeasuresOf([&](const SequenceWalk& walk, const Window& window) {
    return filter->Describe(std::span(walk.descriptors)
                                .subspan(static_cast<std::size_t>(window.first),
                                         static_cast<std::size_t>(window.count)));
  });
}

namespace {

const TrainerRegistration<SeqNetTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
