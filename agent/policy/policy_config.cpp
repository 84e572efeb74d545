// SPDX-License-Identifier: MIT
#include "agent/policy/policy_config.h"

#include "sim/base/error.h"

namespace bulletnav::agent {

void PolicyConfig::Validate() const {
  seeing().Validate();
  for (const int size : {features, memory}) {
    if (size < 16 || size > 4096 || size % 16 != 0) {
      throw sim::Error("features and memory must be multiples of 16 from 16 to 4096");
    }
  }
  if (step_limit < 1) throw sim::Error("step_limit must be at least 1");
}

ModelConfig PolicyConfig::seeing() const {
  ModelConfig config;
  config.encoder = EncoderForm::kPanorama;
  config.depth = DepthFusion::kChannel;
  config.width = width;
  config.rows = rows;
  config.dropout = 0.0;
  config.precision = precision;
  config.norm = Norm::kFixed;
  return config;
}

}  // namespace bulletnav::agent
