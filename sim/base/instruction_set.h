// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::sim {

/// What kernels are compiled for, beside the generic ones; the narrowest first.
enum class InstructionSet { kSse41, kAvx2, kAvx512, kAmx };

/// Whether this processor has an instruction set and the environment variable BULLETNAV_ISA
/// (sse41, avx2, avx512 or amx), if it is set, allows as much: so that one machine can play
/// another's part. kAvx512 is F, DQ, BW and VL; kAmx is TILE and INT8 beside these and VNNI, where
/// the kernel lets the process use them. Throws Error if the variable says anything else.
bool MayUse(InstructionSet set);

}  // namespace bulletnav::sim
