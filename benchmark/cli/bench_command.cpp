// SPDX-License-Identifier: MIT
#include <memory>

#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/scene_options.h"
#include "benchmark/perf/process.h"
#include "benchmark/perf/simulator_figures.h"

namespace bulletnav::bench {
namespace {

struct BenchOptions {
  SceneOptions scene;
  bool json = false;
};

void Bench(const BenchOptions& options) {
  std::vector<Figure> figures;
  const auto tell = [&](const Figure& figure) {
    figures.push_back(figure);
    fmt::print(stderr, "{}: {:.4g} {}\n", figure.name, figure.value, figure.unit);
  };
  MeasureSimulator({options.scene.file, options.scene.import()},
                   std::filesystem::read_symlink("/proc/self/exe"), tell);
  fmt::print("{}", options.json ? ToJson(figures) : ToText(figures));
}

}  // namespace

void AddBenchCommand(CLI::App* program) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = program->add_subcommand(
      "bench", "Measure the simulator on this machine, medians of several runs");
  command->add_flag("--json", options->json, "Print a list of JSON objects");
  command->add_option("--scene", options->scene.file, "Scene to measure on");
  options->scene.AddImportOptions(command);
  command->callback([options] {
    Bench(*options);
  });

  auto first = std::make_shared<SceneOptions>();
  CLI::App* hidden = program->add_subcommand("first-observation", "")->group("");
  first->AddTo(hidden);
  hidden->callback([first] {
    RunFirstObservation(first->file, first->import());
  });
}

}  // namespace bulletnav::bench
