// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::sim {

/// Of a sensor that has no settings.
struct NoSensorConfig {
  template <class V>
  void Visit(V& /*v*/) {}
};

}  // namespace bulletnav::sim
