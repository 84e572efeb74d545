// SPDX-License-Identifier: MIT
#include <string>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/policy/integer_exploration.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

// Takes any rig: it sees maps.
const ModelRegistration registration(
    kExplorationKey,
    [](const std::filesystem::path& weights, const Rig& /*rig*/) {
      const TensorFile content = ReadTensorFile(weights);
      const ExplorationConfig config = ExplorationConfigOf(content, weights);
      const QuantisedNet net = ReadQuantised(content, weights);
      const auto deviation = content.tensors.find(kLogDeviation);
      if (deviation == content.tensors.end()) {
        throw sim::FileError(weights, kLogDeviation, "is missing; train the policy again");
      }
      try {
        return std::make_shared<IntegerExploration>(config, net, deviation->second.values);
      } catch (const sim::Error& error) {
        throw sim::FileError(
            weights, kIntegerPrefix,
            std::string("cannot be used: ") + error.what() + "; train the policy again");
      }
    },
    NumberForm::kIntegers);

}  // namespace
}  // namespace bulletnav::agent
