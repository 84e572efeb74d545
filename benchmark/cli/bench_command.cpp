// SPDX-License-Identifier: MIT
#include "benchmark/cli/commands.h"
namespace bulletnav::bench {
void AddBenchCommand(CLI::App*) {}
}  // namespace bulletnav::bench
