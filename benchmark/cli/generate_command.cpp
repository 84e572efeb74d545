// SPDX-License-Identifier: MIT
#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "benchmark/base/program_version.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/number_range.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/stop_note.h"
#include "benchmark/episodes/made_houses.h"
#include "sim/config/yaml_reader.h"
#include "sim/house/building/kind.h"
#include "sim/house/house_set.h"

namespace bulletnav::bench {
namespace {

struct GenerateOptions {
  sim::HouseSetSpec set;
  std::filesystem::path out = "data/houses";
  sim::SetPart part{.kind = ""};
  std::string split;
  std::filesystem::path file;  // of a set
};

sim::HouseSetSpec SetOf(const GenerateOptions& options) {
  sim::HouseSetSpec set = options.set;
  if (!options.file.empty()) {
    const auto file = sim::LoadYaml<HouseSetFile>(options.file);
    set.first_seed = file.first_seed;
    set.parts = file.parts;
  } else if (!options.part.kind.empty()) {
    sim::SetPart part = options.part;
    part.count = set.count;
    for (const auto& [name, split] : sim::EnumNames<sim::Split>::kNames) {
      if (options.split == name) part.split = split;
    }
    set.parts = {part};
  }
  set.made_by = CommittedVersion();
  return set;
}

std::string KnownKinds() {
  std::string known = "home";
  for (const auto* kind : sim::building::AllKinds()) known.append("|").append(kind->name);
  return known;
}

/// What is said when the program is stopped.
std::string KeptHouses(int made, int count, const std::filesystem::path& folder, bool goes_on) {
  return fmt::format("{} of {} houses are done and stay in {}; {}", made, count, folder.string(),
                     goes_on
                         ? "the same command goes on from there"
                         : "the same command makes them again, as this program is of no commit");
}

void Generate(const GenerateOptions& options) {
  std::vector<sim::HouseEntry> houses;
  {
    const sim::HouseSetSpec set = SetOf(options);
    int count = set.parts.empty() ? set.count : 0;
    for (const sim::SetPart& part : set.parts) count += part.count;
    const int unmade = sim::CountUnmade(options.out, set);
    if (unmade < count) {
      fmt::print(stderr, "{} of {} houses are there already\n", count - unmade, count);
    }
    std::atomic<int> made = count - unmade;
    const StopNote note([&] {
      return KeptHouses(made, count, options.out, !set.made_by.empty());
    });
    Progress progress("houses", unmade);
    houses = sim::WriteHouseSet(options.out, set, [&] {
      ++made;
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
      scenes->add_subcommand("generate", "Make furnished buildings with their descriptions");
  command->add_option("--count", options->set.count, "How many")
      ->check(CLI::Range(1, 9999))
      ->capture_default_str();
  command
      ->add_option("--seed", options->set.first_seed,
                   "Seed of the first house; the others count on from it")
      ->check(CLI::Range(0, 1'000'000'000))
      ->capture_default_str();
  CLI::Option* kind = command->add_option(
      "--kind", options->part.kind,
      "Kind of building: " + KnownKinds() + "; without it, homes as older versions made them");
  command->add_option("--split", options->split, "Put all into this split; else shared out 68:4:14")
      ->check(CLI::IsMember({"train", "val", "test"}))
      ->needs(kind);
  command
      ->add_option("--min-area", options->part.min_area_m2,
                   "Least floor, m2; 0: the kind's. Homes have a range of their own")
      ->needs(kind);
  command->add_option("--max-area", options->part.max_area_m2, "Most floor, m2, likewise")
      ->needs(kind);
  command->add_option("--set", options->file, "A YAML file of kinds, splits and counts instead")
      ->excludes(kind);
  command
      ->add_option("--refurnished", options->set.refurnished.share,
                   "Share of the rooms that is furnished anew: the same houses, years later")
      ->check(NumberFrom(0.0, 1.0));
  command->add_option("--out", options->out, "Folder to write to")->capture_default_str();
  command->add_option("--workers", options->set.workers, "Threads; 0: one per processor")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command->callback([options] {
    Generate(*options);
  });
}

}  // namespace bulletnav::bench
