// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "agent/models/safetensors.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::agent {

/// The configuration that a file of weights holds as YAML under a key of its metadata; `whose`,
/// what is missing and what to do, as in "a policy; train it again". Throws FileError, naming
/// `file`, if it is missing or bad.
template <class Config>
Config ConfigInWeights(const TensorFile& weights, const char* key,
                       const std::filesystem::path& file, const std::string& whose) {
  const auto found = weights.metadata.find(key);
  if (found == weights.metadata.end()) {
    const auto task = weights.metadata.find("task");
    throw sim::FileError(file, "",
                         "does not hold the weights of " + whose +
                             (task == weights.metadata.end()
                                  ? ""
                                  : ", or name another file: this is of task: " + task->second));
  }
  return sim::LoadYamlText<Config>(found->second, file);
}

}  // namespace bulletnav::agent
