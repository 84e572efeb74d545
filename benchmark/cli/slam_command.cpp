// SPDX-License-Identifier: MIT
// Commands of topological SLAM. They are in bulletnav-slam.so; see slam.h.
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "agent/slam/pose_graph/optimize.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/program.h"
#include "benchmark/cli/scene_options.h"
#include "benchmark/cli/slam_commands.h"
#include "benchmark/slam/io/g2o.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

struct SlamOptimizeOptions {
  std::filesystem::path graph;
  std::filesystem::path out;
  agent::OptimizeOptions optimize;
};

void PrintReport(std::size_t vertices, std::size_t edges, const agent::OptimizeSummary& summary,
                 double seconds) {
  fmt::print("| vertices | edges | pieces | cost before | cost after | iterations | seconds |\n");
  fmt::print("|---:|---:|---:|---:|---:|---:|---:|\n");
  fmt::print("| {} | {} | {} | {:.6g} | {:.6g} | {} | {:.3f} |\n", vertices, edges, summary.pieces,
             summary.initial_cost, summary.final_cost, summary.iterations, seconds);
}

/// Trouble that has no line is told with the file at least.
agent::OptimizeSummary Optimized(const SlamOptimizeOptions& options, AnyPoseGraph* graph) {
  try {
    return std::visit(
        [&](auto& any) {
          return agent::Optimize(options.optimize, &any);
        },
        *graph);
  } catch (const sim::Error& e) {
    throw sim::FileError(options.graph, "", e.what());
  }
}

void OptimizeFile(const SlamOptimizeOptions& options) {
  AnyPoseGraph graph = ReadG2o(options.graph);
  const auto start = std::chrono::steady_clock::now();
  const agent::OptimizeSummary summary = Optimized(options, &graph);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  WriteG2o(options.out, graph);
  std::visit(
      [&](const auto& any) {
        PrintReport(any.vertices.size(), any.edges.size(), summary, took.count());
      },
      graph);
  if (!summary.converged) {
    fmt::print(stderr, "stopped after {} iterations before it came to rest; see --iterations\n",
               summary.iterations);
  }
  fmt::print(stderr, "written to {}\n", options.out.string());
}

void AddOptimizeCommand(CLI::App* slam) {
  auto options = std::make_shared<SlamOptimizeOptions>();
  CLI::App* command =
      slam->add_subcommand("optimize", "Move the poses of a .g2o file to where it fits best");
  command->add_option("graph", options->graph, "File with SE2 or SE3:QUAT vertices and edges")
      ->required();
  command->add_option("--out", options->out, "File for the optimised graph")->required();
  AddEnumOption(command, "--robust", &options->optimize.kernel,
                "How far loops that fit badly are trusted, none: all the same")
      ->default_str("none");
  command
      ->add_option("--width", options->optimize.kernel_width,
                   "Standard deviations from which on a loop counts less")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--iterations", options->optimize.max_iterations, "At most")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_flag("--pieces", options->optimize.allow_pieces,
                    "Allow a graph in pieces; each stays where its first vertex is");
  command->callback([options] {
    OptimizeFile(*options);
  });
}

}  // namespace

void AddSlamCommand(CLI::App* program) {
  CLI::App* slam =
      program->add_subcommand("slam", "Topological SLAM: recordings, loops, pose graphs");
  slam->require_subcommand(1);
  AddOptimizeCommand(slam);
  AddSlamTraverseCommand(slam);
  AddSlamImportCommand(slam);
  AddSlamExportCommand(slam);
  AddSlamRunCommand(slam);
  AddSlamTableCommand(slam);
  AddSlamPlotCommand(slam);
  AddSlamScaleCommand(slam);
}

}  // namespace bulletnav::bench

extern "C" int BulletnavRunSlamCommand(int argc, char** argv) {
  return bulletnav::bench::RunProgram(argc, argv, bulletnav::bench::AddSlamCommand);
}
