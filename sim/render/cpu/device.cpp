// SPDX-License-Identifier: MIT
#include "sim/render/cpu/device.h"

#include "sim/base/error.h"

namespace bulletnav::sim {

EmbreeDevice NewEmbreeDevice() {
  EmbreeDevice device(rtcNewDevice("threads=1,user_threads=1,set_affinity=0"));
  if (!device) throw RenderError("Embree cannot start on this processor");
  return device;
}

}  // namespace bulletnav::sim
