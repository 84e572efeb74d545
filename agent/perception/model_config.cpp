// SPDX-License-Identifier: MIT
#include "agent/perception/model_config.h"

#include "sim/base/error.h"

namespace bulletnav::agent {

void ModelConfig::Validate() const {
  if (rows != 128 && rows != 64 && rows != 32) throw sim::Error("rows must be 128, 64 or 32");
  if (width < 8 || width > 128 || width % 8 != 0) {
    throw sim::Error("width must be a multiple of 8 from 8 to 128");
  }
  if (pair_features < 16 || pair_features > 1024 || pair_features % 16 != 0) {
    throw sim::Error("pair_features must be a multiple of 16 from 16 to 1024");
  }
  if (!(dropout >= 0.0 && dropout < 1.0)) throw sim::Error("dropout must be in [0, 1)");
}

}  // namespace bulletnav::agent
