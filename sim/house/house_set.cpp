// SPDX-License-Identifier: MIT
#include "sim/house/house_set.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/folder_lock.h"
#include "sim/house/house.h"
#include "sim/house/house_json.h"
#include "sim/house/unfinished_houses.h"
#include "sim/scene/glb_writer.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kTrain = 68;
constexpr int kVal = 4;
constexpr int kTest = 14;
constexpr const char* kIndex = "index.json";

Split SplitOf(int index, int count) {
  constexpr double kAll = kTrain + kVal + kTest;
  const int val = static_cast<int>(std::lround(count * kVal / kAll));
  const int test = static_cast<int>(std::lround(count * kTest / kAll));
  if (index < count - val - test) return Split::kTrain;
  return index < count - test ? Split::kVal : Split::kTest;
}

HouseEntry WriteHouse(const std::filesystem::path& folder, const HouseEntry& planned,
                      TextureCache* textures) {
  const House house = GenerateHouse(planned.seed, textures);
  HouseEntry entry = planned;
  entry.rooms = static_cast<int>(house.plan.rooms.size());
  entry.area_m2 = static_cast<double>(house.plan.area());
  const std::filesystem::path glb = folder / entry.file;
  std::filesystem::path json = glb;
  json.replace_extension(".json");
  const HouseDescription description{house.seed, std::string(NameOf(house.style.kind)), house.plan};
  WriteFileAtomically(glb, EncodeGlb(house.mesh));
  WriteFileAtomically(json, ToJson(description));
  return entry;
}

/// What is to be written, its rooms and area not known yet.
std::vector<HouseEntry> Plan(const HouseSetSpec& spec) {
  constexpr int kMost = 9999;
  if (spec.count < 1 || spec.count > kMost) {
    throw Error(fmt::format("count is {}; it must be in 1..{}", spec.count, kMost));
  }
  std::vector<HouseEntry> entries;
  entries.reserve(static_cast<std::size_t>(spec.count));
  for (int i = 0; i < spec.count; ++i) {
    entries.push_back({fmt::format("house_{:03}.glb", i), SplitOf(i, spec.count),
                       spec.first_seed + static_cast<std::uint64_t>(i), 0, 0.0});
  }
  return entries;
}

/// Those of the planned houses that are not there yet; fills in the others.
std::vector<HouseEntry*> Unmade(const UnfinishedHouses& left, std::vector<HouseEntry>* planned) {
  std::vector<HouseEntry*> unmade;
  for (HouseEntry& house : *planned) {
    if (!left.Find(&house)) unmade.push_back(&house);
  }
  return unmade;
}

std::string HousesText(const std::vector<HouseEntry>& houses) {
  if (houses.empty()) return "no houses";
  if (houses.size() == 1) return fmt::format("one house of seed {}", houses[0].seed);
  return fmt::format("{} houses of seeds {} to {}", houses.size(), houses.front().seed,
                     houses.back().seed);
}

}  // namespace

bool HasHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec) {
  const std::filesystem::path index = folder / kIndex;
  std::error_code ignored;  // who writes there will say it
  if (!std::filesystem::exists(index, ignored)) return false;
  const std::vector<HouseEntry> old = ReadHouseIndex(index);
  const std::vector<HouseEntry> planned = Plan(spec);
  const auto same_seed = [](const HouseEntry& a, const HouseEntry& b) {
    return a.seed == b.seed;
  };
  if (std::equal(old.begin(), old.end(), planned.begin(), planned.end(), same_seed)) return true;
  throw FileError(
      index, "",
      fmt::format(
          "lists {}; asked for: {}; give its own count and first seed, or name another folder",
          HousesText(old), HousesText(planned)));
}

int CountUnmade(const std::filesystem::path& folder, const HouseSetSpec& spec) {
  HasHouseSet(folder, spec);
  const UnfinishedHouses left(folder, spec.made_by, spec.first_seed);
  std::vector<HouseEntry> planned = Plan(spec);
  return static_cast<int>(Unmade(left, &planned).size());
}

std::vector<HouseEntry> WriteHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec,
                                      const std::function<void()>& advance) {
  std::vector<HouseEntry> entries = Plan(spec);
  const FolderLock lock(folder);
  HasHouseSet(folder, spec);
  UnfinishedHouses left(folder, spec.made_by, spec.first_seed);
  left.Begin();
  const std::vector<HouseEntry*> unmade = Unmade(left, &entries);
  WorkerPool pool(spec.workers);
  std::vector<TextureCache> textures(static_cast<std::size_t>(pool.workers()));
  pool.ForEach(static_cast<int>(unmade.size()), [&](int task, int worker) {
    HouseEntry& entry = *unmade[static_cast<std::size_t>(task)];
    entry = WriteHouse(folder, entry, &textures[static_cast<std::size_t>(worker)]);
    left.Add(entry);
    advance();
  });
  const Json index = {{"first_seed", spec.first_seed}, {"houses", ToJson(entries)}};
  WriteFileAtomically(folder / kIndex, index.dump(1) + "\n");
  left.Finish();
  return entries;
}

}  // namespace bulletnav::sim
