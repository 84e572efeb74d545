// SPDX-License-Identifier: MIT
// The commands that are in bulletnav-learning.so; see learning.h.
#include "benchmark/cli/commands.h"
#include "benchmark/cli/program.h"

extern "C" int BulletnavRunLearningCommand(int argc, char** argv) {
  return bulletnav::bench::RunProgram(argc, argv, [](CLI::App* program) {
    bulletnav::bench::AddTrainCommand(program);
    bulletnav::bench::AddEvaluatePerceptionCommand(program);
    bulletnav::bench::AddQuantiseCommand(program);
  });
}
