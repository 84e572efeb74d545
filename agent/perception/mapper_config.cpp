// SPDX-License-Identifier: MIT
#include "agent/perception/mapper_config.h"

#include "sim/base/error.h"

namespace bulletnav::agent {

void MapperConfig::Validate() const {
  seeing().Validate();
  if (features < 16 || features > 1024 || features % 16 != 0) {
    throw sim::Error("features must be a multiple of 16 from 16 to 1024");
  }
}

ModelConfig MapperConfig::seeing() const {
  ModelConfig config;
  config.encoder = EncoderForm::kPanorama;
  config.depth = DepthFusion::kNone;
  config.width = width;
  config.rows = rows;
  config.dropout = dropout;
  config.precision = precision;
  return config;
}

}  // namespace bulletnav::agent
