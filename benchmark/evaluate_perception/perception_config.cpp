// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_config.h"

#include "sim/base/error.h"

namespace bulletnav::bench {

void PerceptionConfig::Validate() const {
  if (data.points < 2) throw sim::Error("data: points must be at least 2, for there to be pairs");
  for (const double threshold : {same_node, explorable}) {
    if (!(threshold > 0.0 && threshold < 1.0)) {
      throw sim::Error("same_node and explorable must lie between 0 and 1");
    }
  }
  if (pictures < 0 || pictures > 100) throw sim::Error("pictures must lie between 0 and 100");
  if (weights.empty()) throw sim::Error("'weights' is empty; name a file");
  if (out.empty()) throw sim::Error("'out' is empty; name a folder");
}

}  // namespace bulletnav::bench
