// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace bulletnav::sim::internal {

/// Ends the program with the place and the condition that does not hold. For headers that many
/// include, which check.h would make slower to read.
[[noreturn]] void CheckFailed(std::string_view file, int line, std::string_view condition,
                              const std::string& values);

}  // namespace bulletnav::sim::internal
