// SPDX-License-Identifier: MIT
// The commands that need torch, in a program of their own: see forwarded_commands.cpp.
#include <cstdlib>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/hand_over.h"
#include "benchmark/cli/program.h"

int main(int argc, char** argv) {
  return bulletnav::bench::RunProgram(argc, argv, [](CLI::App* program) {
    // Started by itself: OpenBLAS has to be set up before it is loaded, see HandOverToLearn.
    if (std::getenv("OPENBLAS_NUM_THREADS") == nullptr) bulletnav::bench::HandOverToLearn();
    bulletnav::bench::AddTrainCommand(program);
    bulletnav::bench::AddEvaluatePerceptionCommand(program);
    bulletnav::bench::AddRunCommand(program);
    bulletnav::bench::AddMergeCommand(program);
    bulletnav::bench::AddTableCommand(program);
    bulletnav::bench::AddPlotCommand(program);
  });
}
