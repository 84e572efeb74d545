// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/sequence_config.h"

#include "agent/models/config_in_weights.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::agent {

void SequenceConfig::Validate() const {
  if (clusters < 2 || clusters > 256) {
    throw sim::KeyError("clusters", "clusters must lie between 2 and 256");
  }
  if (channels < 16 || channels > 512) {
    throw sim::KeyError("channels", "channels must lie between 16 and 512");
  }
  if (size < 16 || size > 1024 || size > whole()) {
    throw sim::KeyError("size", "size must lie between 16 and 1024");
  }
}

SequenceConfig SequenceConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  return ConfigInWeights<SequenceConfig>(weights, kSequenceKey, file,
                                         "a descriptor of sequences; train one with "
                                         "configs/train/seqvlad.yaml");
}

}  // namespace bulletnav::agent
