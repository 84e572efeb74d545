// SPDX-License-Identifier: MIT
#include "agent/models/model_slot.h"

#include "sim/base/error.h"

namespace bulletnav::agent {

void Models::FailWithout(std::string_view slot, std::string_view what) {
  const std::string name(slot);
  throw sim::Error("needs a " + std::string(what) + "; 'models: {" + name +
                   ": learned}' (or a file of weights, or oracle) in its entry of a run's config "
                   "gives it one");
}

}  // namespace bulletnav::agent
