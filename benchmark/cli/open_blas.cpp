// SPDX-License-Identifier: MIT
#include "benchmark/cli/open_blas.h"

#include <cstdlib>

#include "sim/base/instruction_set.h"

namespace bulletnav::bench {
namespace {

/// Null if OpenBLAS has to find out.
const char* NameOf([[maybe_unused]] BlasKernels kernels) {
#if defined(__x86_64__)
  if (kernels == BlasKernels::kFastest && sim::MayUse(sim::InstructionSet::kAvx512)) {
    return "SkylakeX";
  }
  if (sim::MayUse(sim::InstructionSet::kAvx2) && __builtin_cpu_supports("fma")) return "Haswell";
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
