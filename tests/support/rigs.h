// SPDX-License-Identifier: MIT
#pragma once
#include "agent/observation.h"

namespace bulletnav::tests {

/// Panoramas of 8 x 32.
inline agent::Rig SmallRig() {
  agent::Rig rig;
  rig.panorama.rows = 8;
  rig.panorama.cols = 32;
  return rig;
}

}  // namespace bulletnav::tests
