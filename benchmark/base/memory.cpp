// SPDX-License-Identifier: MIT
#include "benchmark/base/memory.h"

#include <algorithm>
#include <fstream>

#include <fmt/core.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// A file with one number, or with a word, as "max".
std::optional<double> NumberIn(const char* file) {
  double number = 0.0;
  if (std::ifstream(file) >> number) return number;
  return std::nullopt;
}

/// Of the machine.
std::optional<double> Available() {
  constexpr double kKilobyte = 1024.0;
  std::ifstream lines("/proc/meminfo");
  std::string name;
  double number = 0.0;
  std::string unit;
  while (lines >> name >> number) {
    std::getline(lines, unit);
    if (name == "MemAvailable:") return number * kKilobyte;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> FreeMemory() {
  std::optional<double> available = Available();
  const std::optional<double> allowed = NumberIn("/sys/fs/cgroup/memory.max");
  const std::optional<double> taken = NumberIn("/sys/fs/cgroup/memory.current");
  if (!allowed || !taken) return available;
  const double left = std::max(0.0, *allowed - *taken);
  return available ? std::min(*available, left) : left;
}

void RequireMemory(double bytes, const std::string& what, const std::string& remedy) {
  constexpr double kGigabyte = 1e9;
  const std::optional<double> available = FreeMemory();
  if (!available || bytes <= *available) return;
  throw sim::Error(fmt::format("{} takes {:.1f} GB of memory, but {:.1f} GB are free; {}", what,
                               bytes / kGigabyte, *available / kGigabyte, remedy));
}

}  // namespace bulletnav::bench
