// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::bench {

enum class BlasKernels {
  kFastest,  // AVX-512's where the processor has them: results differ in their last bits
  kCommon,   // AVX2's, the same bytes on all processors that have it
};

/// Says in the environment, where OpenBLAS reads it once it is loaded, which kernels it takes, and
/// that it has one thread, since more only get in the way of ours. Debian 12's takes processors
/// newer than itself for ones of 2004, with a quarter of the speed. What the user has set stays;
/// BULLETNAV_ISA narrows these kernels, too. Throws sim::Error if that says what it may not.
void SetUpOpenBlas(BlasKernels kernels);

}  // namespace bulletnav::bench
