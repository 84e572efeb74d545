// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/learning.h"
#include "benchmark/cli/scene_options.h"
#include "benchmark/cli/train_figures.h"
#include "benchmark/perf/network_figures.h"
#include "benchmark/perf/process.h"
#include "benchmark/perf/run_figures.h"
#include "benchmark/perf/simulator_figures.h"
#include "sim/base/temporary_folder.h"
#include "sim/house/house_set.h"

namespace bulletnav::bench {
namespace {

struct BenchOptions {
  SceneOptions scene;
  bool json = false;
  std::string only;  // "simulator", "networks", "training", "runs", or all
};

void Bench(const BenchOptions& options) {
  const auto is_wanted = [&](const char* kind) {
    return options.only.empty() || options.only == kind;
  };
  std::optional<sim::TemporaryFolder> houses;
  std::filesystem::path file = options.scene.file;
  if (file.empty() && (is_wanted("simulator") || is_wanted("training") || is_wanted("runs"))) {
    fmt::print(stderr, "generating a house (seed 0)\n");
    const std::filesystem::path folder = houses.emplace().path();
    sim::WriteHouseSet(folder, {.count = 1, .first_seed = 0, .workers = 1}, [] {});
    file = folder / "house_000.glb";
  }
  std::vector<BenchFigure> figures;
  const auto tell = [&](const BenchFigure& figure) {
    figures.push_back(figure);
    fmt::print(stderr, "{}: {:.4g} {}\n", figure.name, figure.value, figure.unit);
  };
  const BenchScene scene = {file, options.scene.import()};
  if (is_wanted("simulator")) {
    MeasureSimulator(scene, std::filesystem::read_symlink("/proc/self/exe"), tell);
  }
  if (is_wanted("networks")) MeasureNetworks(tell);
  if (is_wanted("runs")) {
    MeasureRuns(scene, tell);
    MeasureLearnedRuns(scene, tell);
  }
  if (is_wanted("training")) {
    MeasureMapSimulator(scene, tell);
    MeasureTrainingThere(scene, tell);
  }
  fmt::print("{}", options.json ? ToJson(figures) : ToText(figures));
}

}  // namespace

void AddBenchCommand(CLI::App* program) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = program->add_subcommand(
      "bench", "Measure simulator and runs on this machine, medians of several times");
  command->add_flag("--json", options->json, "Print a list of JSON objects");
  command->add_option("--scene", options->scene.file,
                      "Scene to measure on; without it, a house is generated");
  command
      ->add_option("--only", options->only,
                   "Only these figures: simulator, networks, runs or training")
      ->check(CLI::IsMember({"simulator", "networks", "runs", "training"}));
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
