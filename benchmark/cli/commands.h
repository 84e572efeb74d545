// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/App.hpp>

namespace bulletnav::bench {

/// Each adds its subcommands to the program; a subcommand's callback does the work and reports
/// trouble by throwing sim::Error.
void AddBenchCommand(CLI::App* program);
void AddCompareCommand(CLI::App* program);
void AddDatasetCommand(CLI::App* program);
void AddTrainCommand(CLI::App* program);
void AddEvaluatePerceptionCommand(CLI::App* program);
void AddEvaluatePolicyCommand(CLI::App* program);
void AddEpisodesCommand(CLI::App* program);
/// Joins the shards of a run.
void AddMergeCommand(CLI::App* program);
void AddPlotCommand(CLI::App* program);
void AddQuantiseCommand(CLI::App* program);
void AddRenderCommand(CLI::App* program);
/// Add "generate" and "export" to the "scenes" command.
void AddGenerateCommand(CLI::App* scenes);
void AddExportCommand(CLI::App* scenes);
/// Makes a page of a run for a browser.
void AddReplayCommand(CLI::App* program);
void AddRunCommand(CLI::App* program);
void AddScenesCommand(CLI::App* program);
void AddSlamCommand(CLI::App* program);
void AddStitchCommand(CLI::App* program);
void AddTableCommand(CLI::App* program);
/// Tells what a file of weights holds.
void AddWeightsCommand(CLI::App* program);

}  // namespace bulletnav::bench
