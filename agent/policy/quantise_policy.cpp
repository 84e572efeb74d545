// SPDX-License-Identifier: MIT
#include "agent/policy/quantise_policy.h"

#include <cmath>

#include "agent/integer/integer_encoder.h"
#include "agent/models/semantic_model.h"
#include "agent/perception/quantise.h"
#include "agent/perception/quantise_trunk.h"
#include "agent/policy/integer_policy.h"
#include "agent/policy/restore_policy.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kRoom = 1.5;  // for what is larger than all of calibration

class PolicyQuantiser {
 public:
  explicit PolicyQuantiser(PolicyNet* net) : net_(*net), quantiser_(*net) {}

  QuantisedNet Run(const PolicyCalibration& calibration) {
    Encoder(calibration.pictures);
    const std::int64_t size = PolicyNet::kCodes;
    const torch::Tensor shown = net_.Encode(calibration.pictures);
    const torch::Tensor codes = shown.narrow(1, 0, size);
    const torch::Tensor goals = net_.Encode(calibration.goal_pictures).narrow(1, 0, size);
    quantiser_.Dense16("whole", code_step_, kPolicyLargest);
    const torch::Tensor here = Apply("whole", codes).relu();
    const torch::Tensor there = Apply("whole", goals).relu();
    torch::Tensor all = at::cat({here, there});
    torch::Tensor turns;
    if (net_.config().fusion == Fusion::kCorrelation) {
      turns = Correlation(codes, goals);
      all = at::cat({all, Apply("matches", turns).relu()});
    }
    // What is joined has one scale, but for products and numbers.
    const double step = quantiser_.RoomyScale("whole", all, kPolicyLargest, kRoom);
    std::vector<torch::Tensor> parts = {here, there, here * there, calibration.numbers};
    if (turns.defined()) parts.push_back(Apply("matches", turns).relu());
    if (net_.config().map) parts.push_back(Map(shown.narrow(1, size, net_.code_size() - size)));
    Join(parts, step);
    quantiser_.Dense16("gru_memory", kPolicyMemoryStep, kPolicyLargest);
    quantiser_.Dense16("policy_head", kPolicyMemoryStep, kPolicyLargest);
    return *quantiser_.net();
  }

 private:
  torch::Tensor Apply(const std::string& name, const torch::Tensor& x) {
    return at::linear(x, quantiser_.Weight(name + ".weight"), quantiser_.Weight(name + ".bias"));
  }

  void Encoder(const torch::Tensor& pictures) {
    if (net_.sight()) {
      for (const auto& [name, layer] : net_.sight()->net().layers) {
        quantiser_.net()->layers[name] = layer;
      }
      for (const auto& [name, scale] : net_.sight()->net().scales) {
        quantiser_.net()->scales[name] = scale;
      }
    } else {
      QuantiseEncoder("encoder.", PolicyInput(net_.config(), pictures), &quantiser_);
    }
    code_step_ = quantiser_.net()->Scale("encoder.second");
  }

  torch::Tensor Correlation(const torch::Tensor& codes, const torch::Tensor& goals) {
    const auto of = [&](const char* name, const torch::Tensor& x) {
      quantiser_.Dense16(name, code_step_, kPolicyLargest);
      const torch::Tensor matches = Apply(name, x.reshape({-1, kDirections, kCodeSize}));
      quantiser_.RoomyScale(name, matches, kPolicyLargest, kRoom);
    };
    of("source_match", codes);
    of("goal_match", goals);
    const torch::Tensor turns = net_.Correlation(codes, goals);
    const double step = quantiser_.RoomyScale("correlation", turns, kPolicyLargest, kRoom);
    quantiser_.Dense16("matches", step, kPolicyLargest);
    return turns;
  }

  /// What the map's branch comes to.
  torch::Tensor Map(const torch::Tensor& bytes) {
    torch::Tensor x = MapBranch::Planes(bytes);
    double step = 1.0;
    int largest = 1;
    for (const char* conv : kMapConvs) {
      const std::string name = std::string("map.") + conv;
      const torch::Tensor& weight = quantiser_.Weight(name + ".weight");
      // [out, rows of the window, columns of it and channels]
      quantiser_.Dense16(name, step, largest,
                         weight.permute({0, 2, 3, 1}).reshape({weight.size(0), 3, -1}));
      x = at::conv2d(x, weight, quantiser_.Weight(name + ".bias"), 2, 1).relu();
      step = quantiser_.RoomyScale(name, x, kPolicyLargest, kRoom);
      largest = kPolicyLargest;
    }
    quantiser_.Dense16("map.whole", step, kPolicyLargest);
    const torch::Tensor whole = Apply("map.whole", MapBranch::Flat(x)).relu();
    quantiser_.RoomyScale("map.whole", whole, kPolicyLargest, kRoom);
    return whole;
  }

  void Join(const std::vector<torch::Tensor>& parts, double step) {
    const torch::Tensor factors = torch::tensor(JoinedFactors(net_.config(), *quantiser_.net()));
    quantiser_.Dense16("joined", step, kPolicyLargest,
                       quantiser_.Weight("joined.weight") * factors);
    const torch::Tensor joined = Apply("joined", at::cat(parts, 1)).relu();
    const double out = quantiser_.RoomyScale("joined", joined, kPolicyLargest, kRoom);
    quantiser_.Dense16("gru_in", out, kPolicyLargest);
  }

  PolicyNet& net_;
  Quantiser quantiser_;
  double code_step_ = 0.0;
};

}  // namespace

QuantisedNet Quantise(PolicyNet* net, const PolicyCalibration& calibration) {
  if (!net->sight() && !HasIntegerForm(net->config().seeing())) {
    throw sim::Error("only policies whose width is a multiple of 16 can be had in integers");
  }
  const torch::NoGradGuard no_grad;
  return PolicyQuantiser(net).Run(calibration);
}

}  // namespace bulletnav::agent
