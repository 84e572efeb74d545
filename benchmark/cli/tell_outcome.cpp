// SPDX-License-Identifier: MIT
#include "benchmark/cli/tell_outcome.h"

#include <cstdio>

#include <fmt/core.h>

#include "benchmark/report/run_tables.h"

namespace bulletnav::bench {

void TellOutcome(const RunOutcome& outcome) {
  fmt::print("{}\nresults: {}\n", WriteTables(outcome.folder, outcome.results, outcome.agents),
             outcome.folder.string());
  for (const std::string& failures : outcome.failures) {
    fmt::print(stderr, "bulletnav: warning: {}\n", failures);
  }
}

}  // namespace bulletnav::bench
