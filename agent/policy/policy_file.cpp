// SPDX-License-Identifier: MIT
#include "agent/policy/policy_file.h"

#include "agent/models/config_in_weights.h"
#include "agent/perception/model_file.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

PolicyConfig PolicyConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  return ConfigInWeights<PolicyConfig>(weights, kPolicyKey, file, "a policy; train it again");
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
