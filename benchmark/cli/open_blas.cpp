// SPDX-License-Identifier: MIT
#include "benchmark/cli/open_blas.h"

#include <cstdlib>

namespace bulletnav::bench {
namespace {

/// Null if OpenBLAS has to find out.
const char* NameOf([[maybe_unused]] BlasKernels kernels) {
#if defined(__x86_64__)
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq");
  if (has_avx512 && kernels == BlasKernels::kFastest) return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
#endif
  return nullptr;
}

}  // namespace

void SetUpOpenBlas(BlasKernels kernels) {
  constexpr int kKeep = 0;  // what the user has set
  ::setenv("OPENBLAS_NUM_THREADS", "1", kKeep);
  const char* const name = NameOf(kernels);
  if (name != nullptr) ::setenv("OPENBLAS_CORETYPE", name, kKeep);
}

}  // namespace bulletnav::bench
