// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/batch_tensors.h"

#include "agent/perception/encoder.h"
#include "sim/base/check.h"

namespace bulletnav::bench {

torch::Tensor InputOf(const agent::ModelConfig& config, PairBatch* batch) {
  const torch::Tensor color = torch::from_blob(
      batch->color.data(), {batch->count, agent::kPanoramaRows, agent::kPanoramaCols, 3},
      torch::kUInt8);
  torch::Tensor depth;
  if (config.uses_depth()) {
    BULLETNAV_CHECK(!batch->depth.empty());
    depth = torch::from_blob(batch->depth.data(),
                             {batch->count, agent::kPanoramaRows, agent::kPanoramaCols},
                             torch::kFloat32);
  }
  return agent::PrepareInput(config, color, depth);
}

}  // namespace bulletnav::bench
