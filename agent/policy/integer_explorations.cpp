// SPDX-License-Identifier: MIT
#include <memory>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/policy/integer_exploration.h"
#include "agent/policy/policy_file.h"
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
      return MadeOfIntegers(weights, kTrainPolicyAgain, [&] {
        return std::make_shared<IntegerExploration>(config, net, deviation->second.values);
      });
    },
    NumberForm::kIntegers);

}  // namespace
}  // namespace bulletnav::agent
