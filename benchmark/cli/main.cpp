// SPDX-License-Identifier: MIT
#include "agent/models/model_registry.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/forwarded_commands.h"
#include "benchmark/cli/learning.h"
#include "benchmark/cli/program.h"

int main(int argc, char** argv) {
  bulletnav::agent::SetMoreModelKinds(bulletnav::bench::LoadLearning);
  return bulletnav::bench::RunProgram(argc, argv, [&](CLI::App* program) {
    bulletnav::bench::AddScenesCommand(program);
    bulletnav::bench::AddRenderCommand(program);
    bulletnav::bench::AddEpisodesCommand(program);
    bulletnav::bench::AddDatasetCommand(program);
    bulletnav::bench::AddForwardedCommands(program, {argc, argv});
    bulletnav::bench::AddRunCommand(program);
    bulletnav::bench::AddMergeCommand(program);
    bulletnav::bench::AddTableCommand(program);
    bulletnav::bench::AddCompareCommand(program);
    bulletnav::bench::AddPlotCommand(program);
    bulletnav::bench::AddReplayCommand(program);
    bulletnav::bench::AddBenchCommand(program);
    bulletnav::bench::AddWeightsCommand(program);
  });
}
