// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace bulletnav::sim::internal {

/// Ends the program with the place and the condition that does not hold. For headers that others
/// include, where the macros of check.h would meet macros of the same names.
[[noreturn]] void CheckFailed(std::string_view file, int line, std::string_view condition,
                              const std::string& values);

}  // namespace bulletnav::sim::internal
