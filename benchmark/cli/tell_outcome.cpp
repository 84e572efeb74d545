// SPDX-License-Identifier: MIT
#include "benchmark/cli/tell_outcome.h"

#include <fmt/core.h>

#include "benchmark/base/warn_line.h"
#include "benchmark/report/run_tables.h"

namespace bulletnav::bench {

void TellOutcome(const RunOutcome& outcome) {
  fmt::print("{}\nresults: {}\n", WriteTables(outcome.folder, outcome.results, outcome.agents),
             outcome.folder.string());
  for (const std::string& failures : outcome.failures) WarnLine(failures);
}

}  // namespace bulletnav::bench
