// SPDX-License-Identifier: MIT
#include "sim/house/house_set.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/folder_lock.h"
#include "sim/config/json_node.h"
#include "sim/house/building/building.h"
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
constexpr int kMost = 9999;

struct PlannedHouse {
  HouseEntry entry;
  building::AreaLimits limits;
};

Split SplitOf(int index, int count) {
  constexpr double kAll = kTrain + kVal + kTest;
  const int val = static_cast<int>(std::lround(count * kVal / kAll));
  const int test = static_cast<int>(std::lround(count * kTest / kAll));
  if (index < count - val - test) return Split::kTrain;
  return index < count - test ? Split::kVal : Split::kTest;
}

House Generated(const PlannedHouse& planned, const Refurnish& refurnish, TextureCache* textures) {
  const HouseEntry& entry = planned.entry;
  if (entry.kind.empty() || entry.kind == "home") {
    return GenerateHouse(entry.seed, textures, {}, kHomeLight, refurnish);
  }
  return building::GenerateBuilding(building::FindKind(entry.kind), entry.seed, textures,
                                    planned.limits, refurnish);
}

HouseEntry WriteHouse(const std::filesystem::path& folder, const PlannedHouse& planned,
                      const Refurnish& refurnish, TextureCache* textures) {
  const House house = Generated(planned, refurnish, textures);
  HouseEntry entry = planned.entry;
  entry.rooms = static_cast<int>(house.plan.rooms.size());
  entry.area_m2 = static_cast<double>(house.plan.area());
  const std::filesystem::path glb = folder / entry.file;
  std::filesystem::path json = glb;
  json.replace_extension(".json");
  HouseDescription description{house.seed, std::string(NameOf(house.style.kind)), house.plan};
  description.kind = entry.kind;
  description.furniture = house.furniture;
  WriteFileAtomically(glb, EncodeGlb(house.mesh));
  WriteFileAtomically(json, ToJson(description));
  return entry;
}

void RequireCount(int count) {
  if (count < 1 || count > kMost) {
    throw Error(fmt::format("count is {}; it must be in 1..{}", count, kMost));
  }
}

/// The homes of a set without parts.
std::vector<PlannedHouse> PlanHomes(const HouseSetSpec& spec) {
  RequireCount(spec.count);
  std::vector<PlannedHouse> planned;
  planned.reserve(static_cast<std::size_t>(spec.count));
  for (int i = 0; i < spec.count; ++i) {
    planned.push_back({{fmt::format("house_{:03}.glb", i), SplitOf(i, spec.count),
                        spec.first_seed + static_cast<std::uint64_t>(i), 0, 0.0},
                       {}});
  }
  return planned;
}

/// What is to be written, its rooms and area not known yet.
std::vector<PlannedHouse> Plan(const HouseSetSpec& spec) {
  if (spec.parts.empty()) return PlanHomes(spec);
  std::vector<PlannedHouse> planned;
  std::map<std::string, int> made;
  for (const SetPart& part : spec.parts) {
    part.Validate();
    for (int i = 0; i < part.count; ++i) {
      const int number = made[part.kind]++;
      planned.push_back(
          {{fmt::format("{}_{:03}.glb", part.kind, number),
            part.split.value_or(SplitOf(i, part.count)),
            spec.first_seed + static_cast<std::uint64_t>(number), 0, 0.0, part.kind},
           {static_cast<float>(part.min_area_m2), static_cast<float>(part.max_area_m2)}});
    }
  }
  RequireCount(static_cast<int>(planned.size()));
  return planned;
}

/// Those of the planned houses that are not there yet; fills in the others.
std::vector<PlannedHouse*> Unmade(const UnfinishedHouses& left,
                                  std::vector<PlannedHouse>* planned) {
  std::vector<PlannedHouse*> unmade;
  for (PlannedHouse& house : *planned) {
    if (!left.Find(&house.entry)) unmade.push_back(&house);
  }
  return unmade;
}

std::vector<HouseEntry> Entries(const std::vector<PlannedHouse>& planned) {
  std::vector<HouseEntry> entries;
  entries.reserve(planned.size());
  for (const PlannedHouse& house : planned) entries.push_back(house.entry);
  return entries;
}

/// Whether two lists are of the same houses. Homes of a set without parts are told by their seeds.
bool AreSame(const std::vector<HouseEntry>& a, const std::vector<HouseEntry>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const HouseEntry& p, const HouseEntry& q) {
                      if (p.seed != q.seed || p.kind != q.kind) return false;
                      return p.kind.empty() || (p.file == q.file && p.split == q.split);
                    });
}

Json RefurnishJson(const Refurnish& refurnish) {
  return {{"share", refurnish.share}, {"seed", refurnish.seed}};
}

/// What the index of a set says of it.
Refurnish RefurnishedOf(const std::filesystem::path& index) {
  const std::string remedy = "remove it and make the houses again";
  const auto document = ParseJson<Json>(ReadTextFile(index), index, 1, remedy);
  const JsonNode<Json> root(document, index, "", remedy);
  if (!root.Has("refurnished")) return {};
  const JsonNode<Json> told = root.At("refurnished");
  return {told.At("share").Positive(), told.At("seed").Whole()};
}

bool IsSame(const Refurnish& a, const Refurnish& b) {
  return a == b || (a.share == 0.0 && b.share == 0.0);
}

/// Who makes the set, for what an unfinished call leaves.
std::string MadeBy(const HouseSetSpec& spec) {
  if (spec.made_by.empty() || spec.refurnished.share == 0.0) return spec.made_by;
  return spec.made_by + " refurnished " + RefurnishJson(spec.refurnished).dump();
}

std::string HousesText(const std::vector<HouseEntry>& houses, const Refurnish& refurnish) {
  if (refurnish.share > 0.0) {
    return fmt::format("{} with {:.0f}% of the rooms refurnished by seed {}",
                       HousesText(houses, {}), 100.0 * refurnish.share, refurnish.seed);
  }
  if (houses.empty()) return "no houses";
  if (houses.size() == 1) {
    const std::string& kind = houses[0].kind;
    return fmt::format("one {} of seed {}", kind.empty() ? "house" : kind, houses[0].seed);
  }
  return fmt::format("{} houses of seeds {} to {}", houses.size(), houses.front().seed,
                     houses.back().seed);
}

}  // namespace

void SetPart::Validate() const {
  RequireCount(count);
  if (kind != "home") {
    building::CheckLimits(building::FindKind(kind),
                          {static_cast<float>(min_area_m2), static_cast<float>(max_area_m2)});
  } else if (min_area_m2 != 0.0 || max_area_m2 != 0.0) {
    throw Error(
        "homes are 60 to 200 m2; leave min_area_m2 and max_area_m2 (--min-area, --max-area) out");
  }
}

bool HasHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec) {
  const std::filesystem::path index = folder / kIndex;
  std::error_code ignored;  // who writes there will say it
  if (!std::filesystem::exists(index, ignored)) return false;
  const std::vector<HouseEntry> old = ReadHouseIndex(index);
  const std::vector<HouseEntry> planned = Entries(Plan(spec));
  const Refurnish refurnished = RefurnishedOf(index);
  if (AreSame(old, planned) && IsSame(refurnished, spec.refurnished)) return true;
  throw FileError(index, "",
                  fmt::format("lists {}; asked for: {}; give its own kind, count and first seed, "
                              "or name another folder",
                              HousesText(old, refurnished), HousesText(planned, spec.refurnished)));
}

int CountUnmade(const std::filesystem::path& folder, const HouseSetSpec& spec) {
  HasHouseSet(folder, spec);
  const UnfinishedHouses left(folder, MadeBy(spec), spec.first_seed);
  std::vector<PlannedHouse> planned = Plan(spec);
  return static_cast<int>(Unmade(left, &planned).size());
}

std::vector<HouseEntry> WriteHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec,
                                      const std::function<void()>& advance) {
  std::vector<PlannedHouse> planned = Plan(spec);
  const FolderLock lock(folder);
  HasHouseSet(folder, spec);
  UnfinishedHouses left(folder, MadeBy(spec), spec.first_seed);
  left.Begin();
  const std::vector<PlannedHouse*> unmade = Unmade(left, &planned);
  WorkerPool pool(spec.workers);
  std::vector<TextureCache> textures(static_cast<std::size_t>(pool.workers()));
  pool.ForEach(static_cast<int>(unmade.size()), [&](int task, int worker) {
    PlannedHouse& house = *unmade[static_cast<std::size_t>(task)];
    house.entry =
        WriteHouse(folder, house, spec.refurnished, &textures[static_cast<std::size_t>(worker)]);
    left.Add(house.entry);
    advance();
  });
  std::vector<HouseEntry> entries = Entries(planned);
  Json index = {{"first_seed", spec.first_seed}};
  if (spec.refurnished.share > 0.0) index["refurnished"] = RefurnishJson(spec.refurnished);
  index["houses"] = ToJson(entries);
  WriteFileAtomically(folder / kIndex, index.dump(1) + "\n");
  left.Finish();
  return entries;
}

}  // namespace bulletnav::sim
