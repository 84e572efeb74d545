// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace bulletnav::bench {

/// "1 step", "2 steps".
std::string Counted(std::size_t number, std::string_view what);

}  // namespace bulletnav::bench
