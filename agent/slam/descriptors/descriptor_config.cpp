// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/descriptor_config.h"

#include "agent/models/config_in_weights.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::agent {

void DescriptorConfig::Validate() const {
  if (rows != 96 && rows != 48) throw sim::KeyError("rows", "rows must be 96 or 48");
  if (width < 16 || width > 128 || width % 16 != 0) {
    throw sim::KeyError("width", "width must be a multiple of 16 from 16 to 128");
  }
  if (size < 16 || size > 1024 || size % 16 != 0) {
    throw sim::KeyError("size", "size must be a multiple of 16 from 16 to 1024");
  }
}

DescriptorConfig DescriptorConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  return ConfigInWeights<DescriptorConfig>(weights, kDescriptorKey, file,
                                           "a descriptor of pictures; train one with "
                                           "configs/train/place.yaml");
}

}  // namespace bulletnav::agent
