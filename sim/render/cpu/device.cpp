// SPDX-License-Identifier: MIT
#include "sim/render/cpu/device.h"

#include <string>

#include "sim/base/error.h"
#include "sim/base/instruction_set.h"

namespace bulletnav::sim {
namespace {

/// What Embree may use, in its words. Its hierarchies are as good with less.
std::string WidestSet() {
  if (MayUse(InstructionSet::kAvx512)) return "avx512";
  return MayUse(InstructionSet::kAvx2) ? "avx2" : "sse4.2";
}

}  // namespace

EmbreeDevice NewEmbreeDevice() {
  EmbreeDevice device(
      rtcNewDevice(("threads=1,user_threads=1,set_affinity=0,max_isa=" + WidestSet()).c_str()));
  if (!device) throw RenderError("Embree cannot start on this processor");
  return device;
}

}  // namespace bulletnav::sim
