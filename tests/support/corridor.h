// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::tests {

/// The view down a corridor 8 m long and 1.5 m wide, from its closed end; x runs along it.
inline std::vector<float> CorridorDepth(double x) {
  static const auto scene =
      sim::MakeRenderScene(LCorridor(8, 7, 1.5f, 2.6f), sim::Backend::kEmbree);
  const auto yaw = static_cast<float>(-sim::kPi / 2);
  return RenderPanorama(*scene, {}, {{1.0f + static_cast<float>(x), 1.25f, -0.75f}, yaw}).depth;
}

}  // namespace bulletnav::tests
