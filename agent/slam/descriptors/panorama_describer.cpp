// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/panorama_describer.h"

#include <string>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/perception/model_file.h"
#include "agent/slam/descriptors/code_descriptor.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

PanoramaDescriber::PanoramaDescriber(const QuantisedNet& net, int rows, bool uses_depth)
    : encoder_(net, rows, uses_depth) {}

PictureDescriptor PanoramaDescriber::Describe(const Panorama& panorama) {
  return DescribeCodes(encoder_.Encode({&panorama, 1}), size());
}

std::unique_ptr<PanoramaDescriber> LoadPanoramaDescriber(const std::filesystem::path& weights) {
  const TensorFile content = ReadTensorFile(weights);
  const ModelConfig config = ModelConfigOf(content, weights);
  if (!HoldsIntegers(content)) {
    throw sim::FileError(weights, kIntegerPrefix,
                         "is missing: there is no encoder in integers; quantise the weights");
  }
  try {
    return std::make_unique<PanoramaDescriber>(ReadQuantised(content, weights), config.rows,
                                               config.uses_depth());
  } catch (const sim::FileError&) {
    throw;
  } catch (const sim::Error& error) {
    throw sim::FileError(weights, kIntegerPrefix,
                         std::string("has no encoder for panoramas: ") + error.what());
  }
}

}  // namespace bulletnav::agent
