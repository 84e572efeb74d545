// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/App.hpp>

namespace bulletnav::bench {

/// As main got it.
struct CommandLine {
  int argc = 0;
  char** argv = nullptr;
};

/// Adds the commands that are in libraries beside the program, for learning and for SLAM; each
/// loads its own and hands it the whole command line.
void AddForwardedCommands(CLI::App* program, CommandLine line);

}  // namespace bulletnav::bench
