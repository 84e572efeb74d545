// SPDX-License-Identifier: MIT
#include <memory>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/policy/integer_policy.h"
#include "agent/policy/policy_file.h"

namespace bulletnav::agent {
namespace {

const ModelRegistration registration(
    kPolicyKey,
    [](const std::filesystem::path& weights, const Rig& rig) {
      const TensorFile content = ReadTensorFile(weights);
      const PolicyConfig config = PolicyConfigOf(content, weights);
      RequirePolicyRig(rig, content, weights);
      const QuantisedNet net = ReadQuantised(content, weights);
      return MadeOfIntegers(weights, kTrainPolicyAgain, [&] {
        return std::make_shared<IntegerPolicy>(config, net);
      });
    },
    NumberForm::kIntegers);

}  // namespace

}  // namespace bulletnav::agent
