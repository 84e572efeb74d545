// SPDX-License-Identifier: MIT
#include "agent/policy/policy_file.h"

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

}  // namespace bulletnav::agent
