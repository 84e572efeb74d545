// SPDX-License-Identifier: MIT
#include "agent/models/model_registry.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/hand_over.h"
#include "benchmark/cli/program.h"

int main(int argc, char** argv) {
  // The networks are in the other program.
  bulletnav::agent::SetMoreModelKinds(bulletnav::bench::HandOverToLearn);
  return bulletnav::bench::RunProgram(argc, argv, [](CLI::App* program) {
    bulletnav::bench::AddScenesCommand(program);
    bulletnav::bench::AddRenderCommand(program);
    bulletnav::bench::AddEpisodesCommand(program);
    bulletnav::bench::AddDatasetCommand(program);
    bulletnav::bench::AddTrainCommand(program);
    bulletnav::bench::AddEvaluatePerceptionCommand(program);
    bulletnav::bench::AddRunCommand(program);
    bulletnav::bench::AddMergeCommand(program);
    bulletnav::bench::AddTableCommand(program);
    bulletnav::bench::AddCompareCommand(program);
    bulletnav::bench::AddPlotCommand(program);
    bulletnav::bench::AddBenchCommand(program);
  });
}
