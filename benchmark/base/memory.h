// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

namespace bulletnav::bench {

/// Bytes of main memory that this process may still take: what the machine has to give, or less if
/// its control group allows less. Absent where the system does not say.
std::optional<double> FreeMemory();

/// Throws sim::Error "WHAT takes N GB of memory, but M GB are free; REMEDY" if that is so.
void RequireMemory(double bytes, const std::string& what, const std::string& remedy);

}  // namespace bulletnav::bench
