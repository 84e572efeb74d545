// SPDX-License-Identifier: MIT
#include <vector>

#include "agent/integer/kernels/kernels.h"
#include "sim/base/instruction_set.h"

namespace bulletnav::agent {
namespace {

std::vector<const IntegerKernels*> FindSupported() {
  using sim::InstructionSet;
  std::vector<const IntegerKernels*> supported;
#ifdef __x86_64__
  if (sim::MayUse(InstructionSet::kAmx)) supported.push_back(&kIntegerKernelsAmx);
  if (sim::MayUse(InstructionSet::kAvx512)) {
    if (__builtin_cpu_supports("avx512vnni") != 0) supported.push_back(&kIntegerKernelsVnni);
    supported.push_back(&kIntegerKernelsAvx512);
  }
  if (sim::MayUse(InstructionSet::kAvx2)) supported.push_back(&kIntegerKernelsAvx2);
  if (sim::MayUse(InstructionSet::kSse41)) supported.push_back(&kIntegerKernelsSse41);
#endif
  supported.push_back(&kIntegerKernelsGeneric);
  return supported;
}

}  // namespace

std::span<const IntegerKernels* const> SupportedIntegerKernels() {
  static const std::vector<const IntegerKernels*> supported = FindSupported();
  return supported;
}

}  // namespace bulletnav::agent
