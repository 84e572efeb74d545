// SPDX-License-Identifier: MIT
#include "agent/policy/quantise_exploration.h"

#include <string>

#include "agent/perception/quantise_trunk.h"
#include "agent/policy/exploration_view.h"
#include "agent/policy/integer_exploration.h"

namespace bulletnav::agent {
namespace {

constexpr double kRoom = 1.5;  // for what is larger than all of calibration

/// Codes of the views, [n, kExplorationCodes].
torch::Tensor QuantiseConvolutions(const torch::Tensor& views, Quantiser* quantiser) {
  torch::Tensor x = ExplorationInput(views).to(torch::kFloat32);
  for (int i = 0; i < static_cast<int>(kExplorationWidths.size()); ++i) {
    const std::string name = "conv" + std::to_string(i + 1);
    const torch::Tensor& weight = quantiser->Weight(name + ".weight");
    const std::int64_t outputs = weight.size(0);
    // [out, rows of the window, columns of it and channels]
    quantiser->Dense8(name, weight.permute({0, 2, 3, 1}).reshape({outputs, 3, -1}));
    x = at::conv2d(x, weight, quantiser->Weight(name + ".bias"), 1, 1).relu();
    if (i + 1 < static_cast<int>(kExplorationWidths.size())) quantiser->FitScale(name, x, 255);
    if (i < kExplorationPools) x = at::max_pool2d(x, {2, 2});
  }
  return x.permute({0, 2, 3, 1}).reshape({-1, kExplorationCodes});
}

}  // namespace

QuantisedNet Quantise(ExplorationNet* net, const torch::Tensor& views) {
  const torch::NoGradGuard no_grad;
  Quantiser quantiser(*net);
  const auto apply = [&](const std::string& name, const torch::Tensor& x) {
    return at::linear(x, quantiser.Weight(name + ".weight"), quantiser.Weight(name + ".bias"));
  };
  const torch::Tensor codes = QuantiseConvolutions(views, &quantiser);
  const double code_step = quantiser.RoomyScale("codes", codes, kExplorationLargest, kRoom);
  // What a heading adds to each feature, as weights of an input of the largest value.
  const torch::Tensor weight = quantiser.Weight("first.weight");
  const torch::Tensor of_codes = weight.narrow(1, 0, kExplorationCodes);
  const torch::Tensor of_headings =
      at::matmul(weight.narrow(1, kExplorationCodes, net->config().heading_size),
                 quantiser.Weight("headings").t());
  quantiser.Dense16("first", code_step, kExplorationLargest,
                    at::cat({of_codes, of_headings / (code_step * kExplorationLargest)}, 1));
  // Any heading may come with any view.
  const torch::Tensor heading = at::arange(codes.size(0)).remainder(kHeadings).to(torch::kInt64);
  const torch::Tensor first = (at::linear(codes, of_codes, quantiser.Weight("first.bias")) +
                               of_headings.t().index_select(0, heading))
                                  .relu();
  const double first_step = quantiser.RoomyScale("first", first, kExplorationLargest, kRoom);
  quantiser.Dense16("second", first_step, kExplorationLargest);
  const torch::Tensor second = apply("second", first).relu();
  const double second_step = quantiser.RoomyScale("second", second, kExplorationLargest, kRoom);
  quantiser.Dense16("mean", second_step, kExplorationLargest);
  return *quantiser.net();
}

}  // namespace bulletnav::agent
