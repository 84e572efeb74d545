// SPDX-License-Identifier: MIT
#include "sim/base/instruction_set.h"

#include <cstdlib>
#include <string>
#include <string_view>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

InstructionSet Widest() {
  const char* text = std::getenv("BULLETNAV_ISA");
  if (text == nullptr) return InstructionSet::kAvx512;
  const std::string_view name = text;
  if (name == "sse41") return InstructionSet::kSse41;
  if (name == "avx2") return InstructionSet::kAvx2;
  if (name == "avx512") return InstructionSet::kAvx512;
  throw Error("BULLETNAV_ISA is '" + std::string(name) + "'; it may be sse41, avx2 or avx512");
}

bool Has([[maybe_unused]] InstructionSet set) {
#ifdef __x86_64__
  switch (set) {
    case InstructionSet::kSse41:
      return __builtin_cpu_supports("sse4.1") != 0;
    case InstructionSet::kAvx2:
      return __builtin_cpu_supports("avx2") != 0;
    case InstructionSet::kAvx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
             __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0;
  }
#endif
  return false;
}

}  // namespace

bool MayUse(InstructionSet set) {
  return set <= Widest() && Has(set);
}

}  // namespace bulletnav::sim
