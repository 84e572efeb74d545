// SPDX-License-Identifier: MIT
#include "agent/policy/restore_policy.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "agent/integer/quantised_file.h"
#include "agent/policy/integer_policy.h"
#include "agent/policy/policy_file.h"
#include "agent/policy/policy_input.h"
#include "agent/policy/policy_map.h"

namespace bulletnav::agent {
namespace {

constexpr std::string_view kJoined = "joined";
constexpr std::array kLayers = {"whole",     "source_match", "goal_match", "matches",
                                "map.first", "map.second",   "map.third",  "map.whole",
                                "joined",    "gru_in",       "gru_memory", "policy_head"};

/// [outputs, inputs], or [outputs, channels, 3, 3] of a convolution, whose integers lie by rows of
/// the window, its columns and channels.
TensorFile::Tensor Restored(const QuantisedLayer& layer, const std::vector<float>& factors) {
  const int window = layer.segments;
  const int channels = layer.inputs / window;
  TensorFile::Tensor weight;
  weight.shape = {layer.outputs, channels};
  if (window > 1) weight.shape.insert(weight.shape.end(), 2, window);
  weight.values.resize(layer.weights.size());
  const std::size_t area = static_cast<std::size_t>(window) * static_cast<std::size_t>(window);
  const std::size_t row = area * static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < layer.weights.size(); ++i) {
    const std::size_t output = i / row;
    const std::size_t input = i % row;
    const std::size_t channel = input % static_cast<std::size_t>(channels);
    const std::size_t at =
        output * row + channel * area + input / static_cast<std::size_t>(channels);
    weight.values[at] = static_cast<float>(layer.weights[i]) * layer.scale[output];
    if (!factors.empty()) weight.values[at] /= factors[input];
  }
  return weight;
}

}  // namespace

std::vector<float> JoinedFactors(const PolicyConfig& config, const QuantisedNet& net) {
  const double step = net.Scale("whole");
  std::vector<float> factors;
  const auto add = [&](int count, double factor) {
    factors.insert(factors.end(), static_cast<std::size_t>(count), static_cast<float>(factor));
  };
  add(2 * config.features, 1.0);
  add(config.features, PolicyProductStep(step) / step);
  add(kPolicyNumbers, kPolicyNumberStep / step);
  if (config.fusion == Fusion::kCorrelation) add(config.features, 1.0);
  if (config.map) add(kMapFeatures, net.Scale("map.whole") / step);
  return factors;
}

std::vector<std::string> RestoredNumbers(const QuantisedNet& net) {
  std::vector<std::string> names;
  for (const char* layer : kLayers) {
    if (!net.layers.contains(layer)) continue;
    names.push_back(layer + std::string(".weight"));
    names.push_back(layer + std::string(".bias"));
  }
  return names;
}

void RestorePolicy(const PolicyConfig& config, const std::filesystem::path& file,
                   TensorFile* weights) {
  if (!HoldsIntegers(*weights)) return;
  const QuantisedNet net = ReadQuantised(*weights, file);
  const std::vector<float> factors = MadeOfIntegers(file, kTrainPolicyAgain, [&] {
    return JoinedFactors(config, net);
  });
  for (const std::string name : kLayers) {
    const auto found = net.layers.find(name);
    if (found == net.layers.end() || weights->tensors.contains(name + ".weight")) continue;
    const QuantisedLayer& layer = found->second;
    if (name != kJoined) {
      weights->tensors[name + ".weight"] = Restored(layer, {});
    } else if (factors.size() == static_cast<std::size_t>(layer.inputs)) {  // else another's shape
      weights->tensors[name + ".weight"] = Restored(layer, factors);
    }
    weights->tensors[name + ".bias"] = {{layer.outputs}, layer.bias};
  }
}

}  // namespace bulletnav::agent
