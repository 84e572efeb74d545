// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/runs/runner.h"

namespace bulletnav::bench {

/// Writes the tables of results, prints the first and where they are; failed episodes are warned
/// of.
void TellOutcome(const RunOutcome& outcome);

}  // namespace bulletnav::bench
