// SPDX-License-Identifier: MIT
#include "agent/perception/quantise.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "agent/integer/integer_encoder.h"
#include "agent/integer/integer_heads.h"
#include "agent/models/semantic_model.h"
#include "agent/perception/quantise_trunk.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kRoom = 1.5;  // for what is larger than all of calibration
constexpr int kWhole16 = 32767;

torch::Tensor Shares() {
  torch::Tensor shares = torch::zeros({kDirections, 16});
  auto share = shares.accessor<float, 2>();
  for (int i = 0; i < kDirections; ++i) {
    for (int j = 0; j < 16; ++j) {
      share[i][j] =
          static_cast<float>(
              PoolingShares24()[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) /
          24.0f;
    }
  }
  return shares;
}

class SemanticQuantiser {
 public:
  explicit SemanticQuantiser(const SemanticNet& net) : quantiser_(net) {}

  QuantisedNet Run(const torch::Tensor& input) {
    const torch::Tensor codes = QuantiseEncoder("encoder.", input, &quantiser_);
    code_step_ = quantiser_.net()->Scale("encoder.second");
    Describe(codes);
    Compare();
    return *quantiser_.net();
  }

 private:
  torch::Tensor Apply(const std::string& name, const torch::Tensor& x) {
    return at::linear(x, quantiser_.Weight(name + ".weight"), quantiser_.Weight(name + ".bias"));
  }

  /// NAME_hidden and NAME_out. `weight`: of the first, by inputs in steps.
  void Answer(const std::string& name, const torch::Tensor& x, double step, int largest,
              const torch::Tensor& weight) {
    quantiser_.Dense16(name + "_hidden", step, largest, weight);
    const torch::Tensor hidden = Apply(name + "_hidden", x).relu();
    const double hidden_step = quantiser_.RoomyScale(name + "_hidden", hidden, kLargest16, kRoom);
    quantiser_.Dense16(name + "_out", hidden_step, kLargest16);
  }

  void Describe(const torch::Tensor& codes) {
    const std::int64_t count = codes.size(0);
    const torch::Tensor around = at::cat({codes.narrow(1, kDirections - 1, 1), codes, codes}, 1);
    const auto windows = [&](std::int64_t first, std::int64_t width) {
      return around.narrow(1, first, kDirections + width - 1)
          .unfold(1, width, 1)
          .permute({0, 1, 3, 2})
          .reshape({count, kDirections, -1});
    };
    Answer("heads.explorable", windows(0, 3), code_step_, kLargest16, {});
    const torch::Tensor ring = windows(1, kDirections);
    for (const char* name :
         {"heads.source_sum", "heads.goal_sum", "heads.source_match", "heads.goal_match"}) {
      quantiser_.Dense16(name, code_step_, kLargest16);
    }
    source_sum_ = Apply("heads.source_sum", ring);
    goal_sum_ = Apply("heads.goal_sum", ring);
    source_match_ = Apply("heads.source_match", codes);
    goal_match_ = Apply("heads.goal_match", codes);
    quantiser_.RoomyScale("heads.sum", at::cat({source_sum_, goal_sum_}), kWhole16, kRoom);
    quantiser_.RoomyScale("heads.source_match", source_match_, kLargest16, kRoom);
    quantiser_.RoomyScale("heads.goal_match", goal_match_, kLargest16, kRoom);
  }

  /// [n, i, r, matches, directions, neighbours] products of panorama k with k + 1.
  torch::Tensor Windows() {
    constexpr int kMatches = IntegerHeads::kMatches;
    constexpr int kSize = IntegerHeads::kMatchSize;
    const std::int64_t count = source_match_.size(0);
    const auto split = [&](const torch::Tensor& x) {
      return x.view({count, kDirections, kMatches, kSize}).transpose(1, 2);
    };
    const torch::Tensor products =
        at::matmul(split(source_match_), split(goal_match_.roll(-1, 0)).transpose(2, 3)) /
        std::sqrt(double{kSize});
    quantiser_.FitScale("heads.product", products, 127);
    torch::Tensor turns = torch::empty({count, kMatches, kDirections, kDirections});
    for (int a = 0; a < kDirections; ++a) {
      turns.select(2, a).copy_(products.select(2, a).roll(-a, 2).roll(1, 2));
    }
    const torch::Tensor wide = at::cat({turns, turns.narrow(3, 0, 2)}, 3);
    return at::cat({wide, wide.narrow(2, 0, kDirections - 1)}, 2)
        .unfold(2, kDirections, 1)
        .unfold(3, 3, 1)
        .permute({0, 2, 3, 1, 4, 5});
  }

  void Compare() {
    const torch::Tensor windows = Windows();
    const std::int64_t count = windows.size(0);
    // [out, matches, directions, neighbours] to [out, directions, neighbours and matches].
    const torch::Tensor weight = quantiser_.Weight("heads.matches.weight");
    quantiser_.Dense8("heads.matches",
                      weight.view({weight.size(0), IntegerHeads::kMatches, kDirections, 3})
                          .permute({0, 2, 3, 1})
                          .reshape({weight.size(0), kDirections, -1}));
    std::vector<torch::Tensor> turned;
    for (int i = 0; i < kDirections; ++i) turned.push_back(goal_sum_.roll(-1, 0).roll(-i, 1));
    const torch::Tensor sums =
        (Apply("heads.matches", windows.reshape({count, kDirections, kDirections, -1})) +
         source_sum_.unsqueeze(2) + at::stack(turned, 1))
            .relu();
    quantiser_.FitScale("heads.matches", sums, 255);
    quantiser_.Dense8("heads.second");
    const torch::Tensor both = Apply("heads.second", sums).relu();
    const double step = quantiser_.FitScale("heads.second", both, 255) / kDirections;
    const torch::Tensor directions = at::cat({both.amax(2), both.mean(2)}, -1);
    const torch::Tensor whole = at::cat({directions.amax(1), directions.mean(1)}, -1);
    for (const char* name : {"heads.direction", "heads.score"}) {
      Answer(name, directions, step, kDirections * 255, {});
    }
    for (const std::string name : {"heads.connection", "heads.distance"}) {
      // Means over directions come as sums over four.
      torch::Tensor hidden = quantiser_.Weight(name + "_hidden.weight").clone();
      const std::int64_t half = hidden.size(1) / 2;
      hidden.narrow(1, half, half).mul_(4.0 / kDirections);
      Answer(name, whole, step, kDirections * kDirections * 255 / 4, hidden);
    }
  }

  Quantiser quantiser_;
  double code_step_ = 0.0;
  torch::Tensor source_sum_;
  torch::Tensor goal_sum_;
  torch::Tensor source_match_;
  torch::Tensor goal_match_;
};

}  // namespace

torch::Tensor QuantiseEncoder(const std::string& prefix, const torch::Tensor& input,
                              Quantiser* quantiser) {
  const auto apply = [&](const std::string& name, const torch::Tensor& x) {
    return at::linear(x, quantiser->Weight(name + ".weight"), quantiser->Weight(name + ".bias"));
  };
  const std::string trunk = prefix + "trunk.";
  const torch::Tensor map = quantiser->Trunk(trunk, input).back();
  const double step = quantiser->net()->Scale(trunk + "stage4_2_second") * kPooledStep;
  const torch::Tensor features = at::matmul(Shares(), map.mean(2).transpose(1, 2));
  quantiser->Dense16(prefix + "first", step, kLargestPooled);
  const torch::Tensor hidden = apply(prefix + "first", features).relu();
  const double hidden_step = quantiser->RoomyScale(prefix + "first", hidden, kLargest16, kRoom);
  quantiser->Dense16(prefix + "second", hidden_step, kLargest16);
  torch::Tensor codes = apply(prefix + "second", hidden).relu();
  quantiser->RoomyScale(prefix + "second", codes, kLargest16, kRoom);
  return codes;
}

bool HasIntegerForm(const ModelConfig& config) {
  return config.encoder == EncoderForm::kPanorama && config.depth != DepthFusion::kSeparate &&
         config.width % 16 == 0;
}

bool HasIntegerForm(const MapperConfig& config) {
  return config.width % 16 == 0 && config.features % 16 == 0;
}

QuantisedNet Quantise(const SemanticNet& net, const torch::Tensor& input) {
  if (!HasIntegerForm(net.config())) {
    throw sim::Error(
        "only models of form panorama, depth none or channel and a width that is a multiple of 16 "
        "can be had in integers");
  }
  const c10::InferenceMode inference;
  return SemanticQuantiser(net).Run(input.to(torch::kFloat32));
}

QuantisedNet Quantise(const MapperNet& net, const torch::Tensor& input) {
  if (!HasIntegerForm(net.config())) {
    throw sim::Error(
        "only mappers whose width and features are multiples of 16 can be had in "
        "integers");
  }
  const c10::InferenceMode inference;
  Quantiser quantiser(net);
  const std::vector<torch::Tensor> stages = quantiser.Trunk("trunk.", input.to(torch::kFloat32));
  const auto apply = [&](const std::string& name, const torch::Tensor& x) {
    return at::linear(x, quantiser.Weight(name + ".weight"), quantiser.Weight(name + ".bias"));
  };
  torch::Tensor sum;
  float most = 0.0f;
  for (const std::size_t stage : {0u, 1u, 3u}) {
    const torch::Tensor& map = stages[stage];
    const std::string name = "level" + std::to_string(stage + 1);
    // [out, rows * channels] to [out, rows, channels].
    quantiser.Dense8(name, quantiser.Weight(name + ".weight").view({-1, map.size(2), map.size(1)}));
    const torch::Tensor columns = map.permute({0, 3, 2, 1}).reshape({map.size(0), map.size(3), -1});
    const torch::Tensor level = apply(name, columns);
    most = std::max(most, level.abs().max().item<float>());
    const std::int64_t times = stages[0].size(3) / map.size(3);
    const torch::Tensor fine = level.repeat_interleave(times, 1);
    const torch::Tensor next = level.roll(-1, 1).repeat_interleave(times, 1);
    const torch::Tensor share =
        (torch::arange(fine.size(1)) % times / double(times)).view({1, -1, 1});
    const torch::Tensor spread = fine * (1.0 - share) + next * share;
    sum = sum.defined() ? sum + spread : spread;
  }
  most = std::max(most, sum.max().item<float>());
  const double step = quantiser.RoomyScale("levels", torch::tensor({most}), kWhole16, kRoom);
  quantiser.Dense16("hidden", step, kWhole16);
  const torch::Tensor hidden = apply("hidden", sum.relu()).relu();
  quantiser.Dense16("rays", quantiser.RoomyScale("hidden", hidden, kLargest16, kRoom), kLargest16);
  return *quantiser.net();
}

}  // namespace bulletnav::agent
