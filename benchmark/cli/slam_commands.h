// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/App.hpp>

namespace bulletnav::bench {

/// Adds "traverse" to the "slam" command.
void AddSlamTraverseCommand(CLI::App* slam);

}  // namespace bulletnav::bench
