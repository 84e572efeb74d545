// SPDX-License-Identifier: MIT
#include <vector>

#include "sim/base/instruction_set.h"
#include "sim/sensors/noise/kernels/noise_kernels.h"

namespace bulletnav::sim {
namespace {

std::vector<const NoiseKernels*> FindSupported() {
  std::vector<const NoiseKernels*> supported;
#ifdef __x86_64__
  if (MayUse(InstructionSet::kAvx512)) supported.push_back(&kNoiseKernelsAvx512);
  if (MayUse(InstructionSet::kAvx2)) supported.push_back(&kNoiseKernelsAvx2);
#endif
  supported.push_back(&kNoiseKernelsGeneric);
  return supported;
}

}  // namespace

std::span<const NoiseKernels* const> SupportedNoiseKernels() {
  static const std::vector<const NoiseKernels*> supported = FindSupported();
  return supported;
}

}  // namespace bulletnav::sim
