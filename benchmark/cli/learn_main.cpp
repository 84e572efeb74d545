// SPDX-License-Identifier: MIT
// The commands that need torch, in a program of their own: see forwarded_commands.cpp.
#include "benchmark/cli/commands.h"
#include "benchmark/cli/program.h"

int main(int argc, char** argv) {
  return bulletnav::bench::RunProgram(argc, argv, [](CLI::App* program) {
    bulletnav::bench::AddTrainCommand(program);
  });
}
