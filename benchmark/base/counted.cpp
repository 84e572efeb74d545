// SPDX-License-Identifier: MIT
#include "benchmark/base/counted.h"

#include <fmt/core.h>

namespace bulletnav::bench {

std::string Counted(std::size_t number, std::string_view what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

}  // namespace bulletnav::bench
