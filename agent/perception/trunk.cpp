// SPDX-License-Identifier: MIT
#include "agent/perception/trunk.h"

#include <string>

namespace bulletnav::agent {
namespace {

constexpr std::size_t kBlocks = 2;  // a stage
/// What blocks add to their input at first, where no normalisation keeps sums from growing. Source
/// of the idea: Zhang et al., "Fixup initialization", 2019.
constexpr double kFixedBranch = 0.25;

}  // namespace

Trunk::Trunk(const Shape& shape, sim::Rng* rng) : ends_(shape.ends), norm_(shape.norm) {
  stem_ = Add("stem", {shape.in, shape.width, 7, 2, shape.ends, shape.norm}, rng);
  int in = shape.width;
  for (int stage = 0; stage < 4; ++stage) {
    const int out = shape.width << stage;
    const int stride = stage > 0 && stage <= shape.halvings ? 2 : 1;
    const std::string name = "stage" + std::to_string(stage + 1) + "_";
    AddBlock(name + "1", {in, out, 3, stride, shape.ends, shape.norm}, rng);
    AddBlock(name + "2", {out, out, 3, 1, shape.ends, shape.norm}, rng);
    in = out;
  }
}

std::shared_ptr<ConvNorm> Trunk::Add(const std::string& name, const ConvNorm::Shape& shape,
                                     sim::Rng* rng) {
  layers_.push_back(register_module(name, std::make_shared<ConvNorm>(shape, rng)));
  return layers_.back();
}

void Trunk::AddBlock(const std::string& name, ConvNorm::Shape shape, sim::Rng* rng) {
  Block block;
  block.first = Add(name + "_first", shape, rng);
  const double scale = shape.norm == Norm::kFixed ? kFixedBranch : 1.0;
  block.second =
      Add(name + "_second", {shape.out, shape.out, 3, 1, shape.ends, shape.norm, scale}, rng);
  if (shape.stride != 1 || shape.in != shape.out) {
    block.shortcut = Add(name + "_shortcut",
                         {shape.in, shape.out, 1, shape.stride, shape.ends, shape.norm}, rng);
  }
  blocks_.push_back(block);
}

std::vector<torch::Tensor> Trunk::Stages(const torch::Tensor& x) {
  torch::Tensor y = stem_->forward(x).relu_();
  const bool wraps = ends_ == Ends::kMeet;
  y = at::max_pool2d(wraps ? WrapColumns(y, 1) : y, {3, 3}, {2, 2}, {1, wraps ? 0 : 1});
  std::vector<torch::Tensor> stages;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const Block& block = blocks_[i];
    const torch::Tensor kept = block.shortcut ? block.shortcut->forward(y) : y;
    y = block.second->forward(block.first->forward(y).relu_()).add_(kept).relu_();
    if (i % kBlocks == kBlocks - 1) stages.push_back(y);
  }
  return stages;
}

void Trunk::Fold(torch::ScalarType type) {
  for (const auto& layer : layers_) layer->Fold(type);
}

}  // namespace bulletnav::agent
