// SPDX-License-Identifier: MIT
#include "agent/policy/policy_file.h"

#include "agent/perception/model_file.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::agent {

PolicyConfig PolicyConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  const auto found = weights.metadata.find(kPolicyKey);
  if (found == weights.metadata.end()) {
    throw sim::FileError(file, "", "does not hold the weights of a policy; train it again");
  }
  return sim::LoadYamlText<PolicyConfig>(found->second, file);
}

void RequirePolicyRig(const Rig& rig, const PolicyConfig& config,
                      const std::filesystem::path& file) {
  RequireRig(rig, ModelConfig{.depth = DepthFusion::kNone}, file);
  if (!config.map || rig.has_depth) return;
  throw sim::FileError(file, "",
                       "is of a policy that is shown a metric map, which takes depth; this body "
                       "has none: take the setting rgbd");
}

}  // namespace bulletnav::agent
