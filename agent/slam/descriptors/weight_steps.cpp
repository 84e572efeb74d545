// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/weight_steps.h"

#include <cmath>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kLargest = 1 << 20;

}  // namespace

std::vector<std::int32_t> WeightSteps(const TensorFile& weights, const std::string& name,
                                      const std::vector<std::int64_t>& shape, int steps,
                                      const std::filesystem::path& file) {
  const auto found = weights.tensors.find(name);
  if (found == weights.tensors.end() || found->second.shape != shape) {
    throw sim::FileError(file, name,
                         "is missing or has another shape: these are weights of another model");
  }
  std::vector<std::int32_t> rounded;
  rounded.reserve(found->second.values.size());
  for (const float value : found->second.values) {
    const double scaled = std::nearbyint(double{value} * steps);
    if (!(std::abs(scaled) <= kLargest)) {
      throw sim::FileError(file, name, "holds numbers that are too large or none at all");
    }
    rounded.push_back(static_cast<std::int32_t>(scaled));
  }
  return rounded;
}

}  // namespace bulletnav::agent
