// SPDX-License-Identifier: MIT
#include "agent/policy/exploration_net.h"

#include <cmath>
#include <utility>

#include "agent/models/model_registry.h"
#include "agent/perception/encoder.h"
#include "agent/perception/one_thread.h"
#include "agent/perception/weights.h"
#include "agent/policy/exploration_view.h"
#include "agent/policy/integer_exploration.h"
#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::agent {
namespace {

constexpr double kMeanGain = 0.01;
constexpr double kValueGain = 0.7;  // variance 1 / inputs

torch::ScalarType TypeOf(const ExplorationConfig& config) {
  ModelConfig model;
  model.precision = config.precision;
  return ComputeType(model);
}

}  // namespace

PlainConv::PlainConv(int in, int out, sim::Rng* rng) {
  weight_ =
      register_parameter("weight", NormalTensor({out, in, 3, 3}, std::sqrt(2.0 / (9.0 * in)), rng));
  bias_ = register_parameter("bias", torch::zeros({out}));
}

torch::Tensor PlainConv::forward(const torch::Tensor& x) {
  const torch::Tensor weight =
      weight_.to(x.scalar_type()).contiguous(at::MemoryFormat::ChannelsLast);
  return at::conv2d(x, weight, bias_.to(x.scalar_type()), 1, 1);
}

ExplorationNet::ExplorationNet(const ExplorationConfig& config, std::uint64_t seed)
    : config_(config) {
  sim::Rng rng(seed, "exploration_net");
  int channels = kExplorationChannels;
  for (const int width : kExplorationWidths) {
    convs_.push_back(register_module("conv" + std::to_string(convs_.size() + 1),
                                     std::make_shared<PlainConv>(channels, width, &rng)));
    channels = width;
  }
  headings_ =
      register_parameter("headings", NormalTensor({kHeadings, config.heading_size}, 1.0, &rng));
  const auto add = [&](const char* name, int in, int out, double gain) {
    return register_module(name, std::make_shared<Dense>(in, out, &rng, gain));
  };
  first_ = add("first", kExplorationCodes + config.heading_size, config.features, 1.0);
  second_ = add("second", config.features, config.features, 1.0);
  mean_ = add("mean", config.features, 2, kMeanGain);
  value_ = add("value", config.features, 1, kValueGain);
  log_deviation_ = register_parameter(kLogDeviation, torch::zeros({2}));
}

torch::Tensor ExplorationInput(const torch::Tensor& views) {
  const torch::Tensor bits = torch::tensor({1, 2, 4, 8, 16, 32, 64, 128}, torch::kUInt8);
  return views.view({-1, kExplorationSide, kExplorationSide, 1})
      .bitwise_and(bits)
      .ne(0)
      .permute({0, 3, 1, 2});
}

torch::Tensor ExplorationNet::Encode(const torch::Tensor& views) {
  torch::Tensor x = ExplorationInput(views).to(TypeOf(config_));
  for (std::size_t i = 0; i < convs_.size(); ++i) {
    x = convs_[i]->forward(x);
    if (i < kExplorationPools) x = at::max_pool2d(x, {2, 2});
    x.relu_();  // of the largest of four, which is the largest of four ReLUs
  }
  return x.permute({0, 2, 3, 1}).reshape({-1, kExplorationCodes}).to(torch::kFloat32);
}

ExplorationNet::Output ExplorationNet::Answer(const torch::Tensor& codes,
                                              const torch::Tensor& headings) {
  const torch::Tensor turned = headings_.index_select(0, headings.reshape({-1}).to(torch::kInt64));
  std::vector<std::int64_t> shape = headings.sizes().vec();
  shape.push_back(config_.heading_size);
  torch::Tensor x = at::cat({codes, turned.view(shape)}, -1);
  x = second_->forward(first_->forward(x).relu()).relu();
  return {mean_->forward(x), value_->forward(x).squeeze(-1)};
}

GoalDistribution LearnedExploration::Ask(std::span<const std::uint8_t> view, int heading) {
  const torch::NoGradGuard no_grad;
  StayInThisThread();
  torch::Tensor views = torch::empty({1, static_cast<std::int64_t>(view.size())}, torch::kUInt8);
  std::copy(view.begin(), view.end(), views.data_ptr<std::uint8_t>());
  const ExplorationNet::Output output =
      net_->Answer(net_->Encode(views), at::full({1}, heading, torch::kFloat32));
  GoalDistribution goal;
  for (int i = 0; i < 2; ++i) {
    const auto at = static_cast<std::size_t>(i);
    goal.mean[at] = output.means[0][i].item<double>();
    goal.deviation[at] = sim::Exp(net_->log_deviation()[i].item<double>());
  }
  return goal;
}

void SaveExploration(const ExplorationNet& net, std::map<std::string, std::string> notes,
                     StoredType type, const std::filesystem::path& file) {
  TensorFile content;
  content.metadata = std::move(notes);
  content.metadata[kExplorationKey] = sim::ToYaml(net.config());
  AppendWeights(net, "", &content);
  WriteTensorFile(file, content, type);
}

std::shared_ptr<ExplorationNet> LoadExploration(const std::filesystem::path& file) {
  const TensorFile content = ReadTensorFile(file);
  auto net = std::make_shared<ExplorationNet>(ExplorationConfigOf(content, file), 0);
  SetWeights(content, "", file, net.get());
  return net;
}

namespace {

const ModelRegistration registration(kExplorationKey, [](const std::filesystem::path& weights,
                                                         const Rig& /*rig*/) {
  const std::shared_ptr<ExplorationNet> net = LoadExploration(weights);
  net->eval();
  return std::make_shared<LearnedExploration>(net);
});

}  // namespace

}  // namespace bulletnav::agent
