// SPDX-License-Identifier: MIT
#include <vector>

#include "sim/render/kernels/kernels.h"

namespace bulletnav::sim {
namespace {

std::vector<const Kernels*> FindSupported() {
  std::vector<const Kernels*> supported;
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
      __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0) {
    supported.push_back(&kKernelsAvx512);
  }
  if (__builtin_cpu_supports("avx2") != 0) supported.push_back(&kKernelsAvx2);
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
