// SPDX-License-Identifier: MIT
#include "benchmark/cli/commands.h"
#include "benchmark/cli/program.h"

int main(int argc, char** argv) {
  return bulletnav::bench::RunProgram(argc, argv, [](CLI::App* program) {
    bulletnav::bench::AddScenesCommand(program);
    bulletnav::bench::AddRenderCommand(program);
    bulletnav::bench::AddEpisodesCommand(program);
    bulletnav::bench::AddDatasetCommand(program);
    bulletnav::bench::AddTrainCommand(program);
    bulletnav::bench::AddEvaluatePerceptionCommand(program);
    bulletnav::bench::AddRunCommand(program);
    bulletnav::bench::AddTableCommand(program);
    bulletnav::bench::AddCompareCommand(program);
    bulletnav::bench::AddPlotCommand(program);
    bulletnav::bench::AddBenchCommand(program);
  });
}
