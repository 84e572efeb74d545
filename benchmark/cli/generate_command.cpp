// SPDX-License-Identifier: MIT
#include <map>
#include <memory>

#include <fmt/core.h>

#include "benchmark/base/program_version.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "sim/house/house_set.h"

namespace bulletnav::bench {
namespace {

struct GenerateOptions {
  sim::HouseSetSpec set;
  std::filesystem::path out = "data/houses";
};

void Generate(const GenerateOptions& options) {
  std::vector<sim::HouseEntry> houses;
  {
    sim::HouseSetSpec set = options.set;
    set.made_by = CommittedVersion();
    const int unmade = sim::CountUnmade(options.out, set);
    if (unmade < set.count) {
      fmt::print(stderr, "{} of {} houses are there already\n", set.count - unmade, set.count);
    }
    Progress progress("houses", unmade);
    houses = sim::WriteHouseSet(options.out, set, [&] {
      progress.Advance();
    });
  }
  std::map<sim::Split, int> count;
  double area = 0.0;
  int rooms = 0;
  for (const sim::HouseEntry& house : houses) {
    ++count[house.split];
    area += house.area_m2;
    rooms += house.rooms;
  }
  fmt::print("{} houses ({} train, {} val, {} test), {} rooms, {:.0f} m2: {}\n", houses.size(),
             count[sim::Split::kTrain], count[sim::Split::kVal], count[sim::Split::kTest], rooms,
             area, (options.out / "index.json").string());
}

}  // namespace

void AddGenerateCommand(CLI::App* scenes) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command =
      scenes->add_subcommand("generate", "Make furnished houses with their descriptions");
  command->add_option("--count", options->set.count, "How many")
      ->check(CLI::Range(1, 9999))
      ->capture_default_str();
  command
      ->add_option("--seed", options->set.first_seed,
                   "Seed of the first house; the others count on from it")
      ->check(CLI::Range(0, 1'000'000'000))
      ->capture_default_str();
  command->add_option("--out", options->out, "Folder to write to")->capture_default_str();
  command->add_option("--workers", options->set.workers, "Threads; 0: one per processor")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->callback([options] {
    Generate(*options);
  });
}

}  // namespace bulletnav::bench
