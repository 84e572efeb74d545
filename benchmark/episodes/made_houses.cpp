// SPDX-License-Identifier: MIT
#include "benchmark/episodes/made_houses.h"

#include <utility>

#include "sim/base/error.h"
#include "sim/base/folder_lock.h"
#include "sim/house/house_set.h"

namespace bulletnav::bench {
namespace {

using sim::KeyError;

void RequireParts(const std::vector<sim::SetPart>& parts) {
  if (parts.empty()) throw KeyError("parts", "'parts' has no entry");
}

sim::HouseSetSpec SetOf(const HousesSpec& houses) {
  HouseSetFile set = {houses.first_seed, houses.parts.value_or(std::vector<sim::SetPart>())};
  if (houses.set) set = sim::LoadYaml<HouseSetFile>(*houses.set);
  return {.count = houses.count,
          .first_seed = set.first_seed,
          .parts = std::move(set.parts),
          .refurnished = houses.refurnished.value_or(sim::Refurnish())};
}

}  // namespace

void HouseSetFile::Validate() const {
  RequireParts(parts);
}

void HousesSpec::Validate() const {
  if (folder.empty()) throw KeyError("folder", "'folder' is empty; name a folder for the houses");
  if (count < 1 || count > 9999) throw KeyError("count", "count must lie between 1 and 9999");
  if (set && (parts || first_seed != 0)) {
    throw KeyError("set", "the set's file gives first_seed and parts; leave them out here");
  }
  if (parts) RequireParts(*parts);
}

void MakeHouses(const HousesSpec& houses, const std::string& made_by, int workers,
                const StartProgress& start) {
  sim::HouseSetSpec set = SetOf(houses);
  set.made_by = made_by;
  set.workers = workers;
  while (!sim::HasHouseSet(houses.folder, set)) {
    try {
      const int unmade = sim::CountUnmade(houses.folder, set);
      sim::WriteHouseSet(houses.folder, set, start("generating houses", unmade));
    } catch (const sim::FolderBusy&) {
      const auto advance = start("waiting for a process that generates the houses, sets", 1);
      sim::WaitForFolder(houses.folder);
      advance();
    } catch (const sim::FileError&) {
      // What an unfinished call left goes away when another process has made the last house.
      if (!sim::HasHouseSet(houses.folder, set)) throw;
    }
  }
}

std::vector<std::filesystem::path> FilesOf(const HousesSpec& houses) {
  const std::filesystem::path folder = houses.folder;
  if (!sim::HasHouseSet(folder, SetOf(houses))) {
    throw sim::FileError(
        folder, "", "holds no houses yet; ./bulletnav train and ./bulletnav dataset make them");
  }
  std::vector<std::filesystem::path> files;
  for (const sim::HouseEntry& house : sim::ReadHouseIndex(folder / "index.json")) {
    files.push_back(folder / house.file);
  }
  return files;
}

}  // namespace bulletnav::bench
