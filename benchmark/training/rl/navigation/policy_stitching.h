// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/navigation/navigation_scenes.h"

namespace bulletnav::bench {

/// Which policy is to see with which encoder: the config of `stitch`.
struct StitchConfig {
  std::string weights;  // of a policy that sees with an encoder in integers
  std::string encoder;  // of a semantic model in integers, of pictures of as many rows
  NavigationData data;
  int pictures = 2000;  // that both encoders are shown; half of them of goals

  template <class V>
  void Visit(V& v) {
    v.Required("weights", weights);
    v.Required("encoder", encoder);
    v.Required("data", data);
    v("pictures", pictures);
  }
  /// Throws Error.
  void Validate() const;
};

/// Writes the policy that sees with the other encoder to `out`, as trained numbers, to be trained
/// on; see agent::StitchPolicy. Returns the share of codes' variance that is explained. Makes
/// houses that are not there. Throws FileError for weights that cannot be used.
double Stitch(const StitchConfig& config, const std::filesystem::path& out,
              const TrainContext& context);

}  // namespace bulletnav::bench
