// SPDX-License-Identifier: MIT
#include "benchmark/base/warn_line.h"

#include <cstdio>

#include <fmt/core.h>

namespace bulletnav::bench {

void WarnLine(const std::string& what) {
  fmt::print(stderr, "bulletnav: warning: {}\n", what);
}

}  // namespace bulletnav::bench
