// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/App.hpp>

namespace bulletnav::bench {

/// As main got it.
struct CommandLine {
  int argc = 0;
  char** argv = nullptr;
};

/// Adds the commands that need learning; each loads it and hands it the whole command line.
void AddForwardedCommands(CLI::App* program, CommandLine line);

}  // namespace bulletnav::bench
