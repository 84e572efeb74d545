// SPDX-License-Identifier: MIT
#include "sim/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace bulletnav::sim::internal {

void CheckFailed(std::string_view file, int line, std::string_view condition,
                 const std::string& values) {
  std::fprintf(stderr, "%.*s:%d: broken invariant: %.*s%s; please report this as a bug\n",
               static_cast<int>(file.size()), file.data(), line, static_cast<int>(condition.size()),
               condition.data(), values.c_str());
  std::abort();
}

}  // namespace bulletnav::sim::internal
