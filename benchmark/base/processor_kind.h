// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace bulletnav::bench {

/// What tells processors apart between which learned agents may answer differently in the last
/// bits: "AVX-512 with AMX", "AVX-512 with bfloat16", "AVX-512", "AVX2" or "neither AVX2 nor
/// AVX-512". Finer than is known to matter, so that no difference goes unseen.
std::string ProcessorKind();

}  // namespace bulletnav::bench
