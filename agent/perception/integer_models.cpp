// SPDX-License-Identifier: MIT
#include "agent/perception/integer_models.h"

#include "agent/integer/integer_mapper.h"
#include "agent/integer/integer_model.h"
#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/perception/model_file.h"

namespace bulletnav::agent {

std::shared_ptr<SemanticModel> LoadIntegerModel(const std::filesystem::path& weights,
                                                const Rig& rig) {
  const TensorFile content = ReadTensorFile(weights);
  const ModelConfig config = ModelConfigOf(content, weights);
  RequireRig(rig, config, weights);
  const QuantisedNet net = ReadQuantised(content, weights);
  return MadeOfIntegers(weights, "quantise it again", [&] {
    return std::make_shared<IntegerModel>(net, config.rows, config.uses_depth());
  });
}

std::shared_ptr<FreeSpaceModel> LoadIntegerMapper(const std::filesystem::path& weights,
                                                  const Rig& rig) {
  const TensorFile content = ReadTensorFile(weights);
  const ModelConfig config = MapperConfigOf(content, weights).seeing();
  RequireRig(rig, config, weights);
  const QuantisedNet net = ReadQuantised(content, weights);
  return MadeOfIntegers(weights, "quantise it again", [&] {
    return std::make_shared<IntegerMapper>(net, config.rows);
  });
}

namespace {

const ModelRegistration model(kModelKey, LoadIntegerModel, NumberForm::kIntegers);
const ModelRegistration mapper(kMapperKey, LoadIntegerMapper, NumberForm::kIntegers);

}  // namespace

}  // namespace bulletnav::agent
