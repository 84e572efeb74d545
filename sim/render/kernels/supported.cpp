// SPDX-License-Identifier: MIT
#include <vector>

#include "sim/base/instruction_set.h"
#include "sim/render/kernels/kernels.h"

namespace bulletnav::sim {
namespace {

std::vector<const Kernels*> FindSupported() {
  std::vector<const Kernels*> supported;
#ifdef __x86_64__
  if (MayUse(InstructionSet::kAvx512)) supported.push_back(&kKernelsAvx512);
  if (MayUse(InstructionSet::kAvx2)) supported.push_back(&kKernelsAvx2);
#endif
  supported.push_back(&kKernelsGeneric);
  return supported;
}

}  // namespace

std::span<const Kernels* const> SupportedKernels() {
  static const std::vector<const Kernels*> supported = FindSupported();
  return supported;
}

}  // namespace bulletnav::sim
