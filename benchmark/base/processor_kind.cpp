// SPDX-License-Identifier: MIT
#include "benchmark/base/processor_kind.h"

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace bulletnav::bench {
namespace {

#if defined(__x86_64__)
/// A bit of the processor's list of extended features, CPUID leaf 7. Source: Intel's manual, 2A.
bool HasAmxBfloat16() {
  unsigned a = 0;
  unsigned b = 0;
  unsigned c = 0;
  unsigned d = 0;
  return __get_cpuid_count(7, 0, &a, &b, &c, &d) != 0 && (d & (1U << 22)) != 0;
}

bool HasAvx512Bfloat16() {
  unsigned a = 0;
  unsigned b = 0;
  unsigned c = 0;
  unsigned d = 0;
  return __get_cpuid_count(7, 1, &a, &b, &c, &d) != 0 && (a & (1U << 5)) != 0;
}
#endif

}  // namespace

std::string ProcessorKind() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512bw")) {
    if (HasAmxBfloat16()) return "AVX-512 with AMX";
    return HasAvx512Bfloat16() ? "AVX-512 with bfloat16" : "AVX-512";
  }
  if (__builtin_cpu_supports("avx2")) return "AVX2";
#endif
  return "neither AVX2 nor AVX-512";
}

}  // namespace bulletnav::bench
