// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include <CLI/App.hpp>

namespace bulletnav::bench {

/// Adds "traverse" to the "slam" command.
void AddSlamTraverseCommand(CLI::App* slam);
/// All pictures of a run, or only the charts of all its drives together.
enum class SlamPictures { kAll, kCharts };
/// Draws them into the folder's plots/. Throws sim::FileError.
void DrawSlamRun(const std::filesystem::path& folder, SlamPictures pictures);

/// Adds "import" and "export".
void AddSlamImportCommand(CLI::App* slam);
void AddSlamExportCommand(CLI::App* slam);
/// Adds "plot".
void AddSlamPlotCommand(CLI::App* slam);
/// Adds "run" and "table".
void AddSlamRunCommand(CLI::App* slam);
void AddSlamTableCommand(CLI::App* slam);
/// Adds "scale".
void AddSlamScaleCommand(CLI::App* slam);

}  // namespace bulletnav::bench
