// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include <CLI/App.hpp>

namespace bulletnav::bench {

/// The main function of a program with subcommands: every error is one line on standard error and a
/// non-zero status, 2 for bad use, 1 for anything else, also where standard output cannot be
/// written; 130 and 143 after SIGINT and SIGTERM, see StopWatch.
int RunProgram(int argc, char** argv, const std::function<void(CLI::App*)>& add_commands);

}  // namespace bulletnav::bench
