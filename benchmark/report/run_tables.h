// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "benchmark/report/results_table.h"
#include "benchmark/runs/summary.h"

namespace bulletnav::bench {

/// The tables that a run's rows make, laid out like the paper's: success and SPL by difficulty
/// (table 1) for the condition "noise", success by difficulty (table 2) for "no_stop" and
/// "no_noise"; for sequences, by number of goals, a table a condition. Under each row of ours comes
/// the paper's, labelled, where it has one. Agents without results get a row that gives their note.
std::vector<ResultsTable> MakeTables(std::span<const SummaryRow> rows,
                                     std::span<const AgentRow> agents);

/// Writes summary.json, table.md, table.tex, table.csv and, if there are several scenes, scenes.md
/// into a folder of results, atomically. Returns the text of table.md and scenes.md.
std::string WriteTables(const std::filesystem::path& folder,
                        const std::vector<EpisodeResult>& results,
                        std::span<const AgentRow> agents);

/// The same for a folder of results as it is, whether a run goes on in it or not. Throws FileError.
std::string RebuildTables(const std::filesystem::path& folder);

}  // namespace bulletnav::bench
