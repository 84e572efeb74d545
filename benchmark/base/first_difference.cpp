// SPDX-License-Identifier: MIT
#include "benchmark/base/first_difference.h"

#include <sstream>

#include <fmt/core.h>

namespace bulletnav::bench {

std::string FirstDifference(const std::string& there, const std::string& here) {
  std::istringstream old_lines(there);
  std::istringstream new_lines(here);
  for (int number = 1;; ++number) {
    std::string old_line;
    std::string new_line;
    std::getline(old_lines, old_line);
    std::getline(new_lines, new_line);
    if (old_line != new_line || !old_lines || !new_lines) {
      return fmt::format("line {} is '{}' there and '{}' here", number, old_line, new_line);
    }
  }
}

}  // namespace bulletnav::bench
