// SPDX-License-Identifier: MIT
#include "sim/base/instruction_set.h"

#ifdef __x86_64__
#include <cpuid.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

#include <cstdlib>
#include <string>
#include <string_view>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

InstructionSet Widest() {
  const char* text = std::getenv("BULLETNAV_ISA");
  if (text == nullptr) return InstructionSet::kAmx;
  const std::string_view name = text;
  if (name == "sse41") return InstructionSet::kSse41;
  if (name == "avx2") return InstructionSet::kAvx2;
  if (name == "avx512") return InstructionSet::kAvx512;
  if (name == "amx") return InstructionSet::kAmx;
  throw Error("BULLETNAV_ISA is '" + std::string(name) + "'; it may be sse41, avx2, avx512 or amx");
}

#ifdef __x86_64__
/// Whether the processor has AMX for bytes and Linux, which must be asked first, lets us use it.
bool HasAmx() {
  constexpr unsigned kFeatures = 7;
  constexpr unsigned kTileAndInt8 = 3u << 24;
  unsigned a = 0;
  unsigned b = 0;
  unsigned c = 0;
  unsigned d = 0;
  if (__get_cpuid_count(kFeatures, 0, &a, &b, &c, &d) == 0) return false;
  if ((d & kTileAndInt8) != kTileAndInt8) return false;
  constexpr long kRequestPermission = 0x1023;  // ARCH_REQ_XCOMP_PERM
  constexpr long kTileData = 18;               // XFEATURE_XTILEDATA
  return syscall(SYS_arch_prctl, kRequestPermission, kTileData) == 0;
}
#endif

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
    case InstructionSet::kAmx: {
      static const bool has =
          Has(InstructionSet::kAvx512) && __builtin_cpu_supports("avx512vnni") != 0 && HasAmx();
      return has;
    }
  }
#endif
  return false;
}

}  // namespace

bool MayUse(InstructionSet set) {
  return set <= Widest() && Has(set);
}

}  // namespace bulletnav::sim
