// SPDX-License-Identifier: MIT
#include <string>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/policy/integer_policy.h"
#include "agent/policy/policy_file.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

const ModelRegistration registration(
    kPolicyKey,
    [](const std::filesystem::path& weights, const Rig& rig) {
      const TensorFile content = ReadTensorFile(weights);
      const PolicyConfig config = PolicyConfigOf(content, weights);
      RequirePolicyRig(rig, config, weights);
      const QuantisedNet net = ReadQuantised(content, weights);
      try {
        return std::make_shared<IntegerPolicy>(config, net);
      } catch (const sim::Error& error) {
        throw sim::FileError(
            weights, kIntegerPrefix,
            std::string("cannot be used: ") + error.what() + "; train the policy again");
      }
    },
    NumberForm::kIntegers);

}  // namespace

}  // namespace bulletnav::agent
