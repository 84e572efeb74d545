// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <memory>
#include <optional>

#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/scene_options.h"
#include "benchmark/perf/process.h"
#include "benchmark/perf/simulator_figures.h"
#include "sim/base/error.h"
#include "sim/house/house_set.h"

namespace bulletnav::bench {
namespace {

struct BenchOptions {
  SceneOptions scene;
  bool json = false;
};

/// A generated house in a file of its own while it is needed.
class TemporaryHouse {
 public:
  TemporaryHouse() {
    std::string pattern = (std::filesystem::temp_directory_path() / "bulletnav_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw sim::FileError(pattern, "", "cannot be made; set TMPDIR to a folder you may write to");
    }
    folder_ = pattern;
    fmt::print(stderr, "generating a house (seed 0)\n");
    sim::WriteHouseSet(folder_, {.count = 1, .first_seed = 0, .workers = 1}, [] {});
  }
  ~TemporaryHouse() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TemporaryHouse(const TemporaryHouse&) = delete;
  TemporaryHouse& operator=(const TemporaryHouse&) = delete;
  TemporaryHouse(TemporaryHouse&&) = delete;
  TemporaryHouse& operator=(TemporaryHouse&&) = delete;

  std::filesystem::path file() const { return folder_ / "house_000.glb"; }

 private:
  std::filesystem::path folder_;
};

void Bench(const BenchOptions& options) {
  std::optional<TemporaryHouse> house;
  std::filesystem::path file = options.scene.file;
  if (file.empty()) file = house.emplace().file();
  std::vector<Figure> figures;
  const auto tell = [&](const Figure& figure) {
    figures.push_back(figure);
    fmt::print(stderr, "{}: {:.4g} {}\n", figure.name, figure.value, figure.unit);
  };
  MeasureSimulator({file, options.scene.import()}, std::filesystem::read_symlink("/proc/self/exe"),
                   tell);
  fmt::print("{}", options.json ? ToJson(figures) : ToText(figures));
}

}  // namespace

void AddBenchCommand(CLI::App* program) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = program->add_subcommand(
      "bench", "Measure the simulator on this machine, medians of several runs");
  command->add_flag("--json", options->json, "Print a list of JSON objects");
  command->add_option("--scene", options->scene.file,
                      "Scene to measure on; without it, a house is generated");
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
