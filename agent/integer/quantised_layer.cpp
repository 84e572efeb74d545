// SPDX-License-Identifier: MIT
#include "agent/integer/quantised_layer.h"

#include <cmath>

#include "sim/base/error.h"

namespace bulletnav::agent {

const QuantisedLayer& QuantisedNet::Layer(const std::string& name) const {
  const auto found = layers.find(name);
  if (found == layers.end()) throw sim::Error("layer " + name + " is missing");
  return found->second;
}

float QuantisedNet::Scale(const std::string& name) const {
  const auto found = scales.find(name);
  if (found == scales.end()) throw sim::Error("scale " + name + " is missing");
  if (!(std::isfinite(found->second) && found->second > 0.0f)) {
    throw sim::Error("scale " + name + " is not a positive number");
  }
  return found->second;
}

}  // namespace bulletnav::agent
