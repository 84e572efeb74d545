// SPDX-License-Identifier: MIT
#include "sim/import/cpu_time.h"

#include <algorithm>

#include <sys/resource.h>

namespace bulletnav::sim {

void LimitCpuSeconds(int seconds) {
  rlimit limit{};
  ::getrlimit(RLIMIT_CPU, &limit);
  limit.rlim_cur = std::min(static_cast<rlim_t>(seconds), limit.rlim_max);
  ::setrlimit(RLIMIT_CPU, &limit);
}

void AllowCpuSeconds(int more) {
  rlimit limit{};
  ::getrlimit(RLIMIT_CPU, &limit);
  if (limit.rlim_cur == RLIM_INFINITY) return;
  LimitCpuSeconds(static_cast<int>(limit.rlim_cur) + more);
}

}  // namespace bulletnav::sim
