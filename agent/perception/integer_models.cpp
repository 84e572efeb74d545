// SPDX-License-Identifier: MIT
#include "agent/perception/integer_models.h"

#include "agent/integer/integer_model.h"
#include "agent/integer/quantised_file.h"
#include "agent/perception/model_file.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

bool HoldsIntegers(const std::filesystem::path& weights) {
  return HoldsQuantised(ReadTensorFile(weights));
}

std::shared_ptr<SemanticModel> LoadIntegerModel(const std::filesystem::path& weights,
                                                const Rig& rig) {
  const TensorFile content = ReadTensorFile(weights);
  const ModelConfig config = ModelConfigOf(content, weights);
  RequireRig(rig, config, weights);
  const QuantisedNet net = ReadQuantised(content, weights);
  try {
    return std::make_shared<IntegerModel>(net, config.rows, config.uses_depth());
  } catch (const sim::Error& error) {
    throw sim::FileError(weights, kIntegerPrefix,
                         std::string("cannot be used: ") + error.what() + "; quantise it again");
  }
}

}  // namespace bulletnav::agent
