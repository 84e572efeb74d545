// SPDX-License-Identifier: MIT
#include "sim/house/house_set.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/house/house.h"
#include "sim/house/house_json.h"
#include "sim/house/json_node.h"
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
  entry.area_m2 = std::round(100.0 * static_cast<double>(house.plan.area())) / 100.0;
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

std::string ToText(const std::vector<HouseEntry>& entries) {
  Json houses = Json::array();
  for (const HouseEntry& entry : entries) {
    houses.push_back({{"file", entry.file},
                      {"split", NameOf(entry.split)},
                      {"seed", entry.seed},
                      {"rooms", entry.rooms},
                      {"area_m2", entry.area_m2}});
  }
  const Json index = {{"first_seed", entries.front().seed}, {"houses", houses}};
  return index.dump(1) + "\n";
}

}  // namespace

bool HasHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec) {
  const std::filesystem::path index = folder / kIndex;
  if (!std::filesystem::exists(index)) return false;
  const std::vector<HouseEntry> old = ReadHouseIndex(index);
  const std::vector<HouseEntry> planned = Plan(spec);
  const auto same_seed = [](const HouseEntry& a, const HouseEntry& b) {
    return a.seed == b.seed;
  };
  if (std::equal(old.begin(), old.end(), planned.begin(), planned.end(), same_seed)) return true;
  throw FileError(
      index, "",
      fmt::format("lists {} other houses; name another folder, or remove this one first",
                  old.size()));
}

std::vector<HouseEntry> WriteHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec,
                                      const std::function<void()>& advance) {
  std::vector<HouseEntry> entries = Plan(spec);
  HasHouseSet(folder, spec);
  MakeFolder(folder);
  WorkerPool pool(spec.workers);
  std::vector<TextureCache> textures(static_cast<std::size_t>(pool.workers()));
  pool.ForEach(spec.count, [&](int task, int worker) {
    HouseEntry& entry = entries[static_cast<std::size_t>(task)];
    entry = WriteHouse(folder, entry, &textures[static_cast<std::size_t>(worker)]);
    advance();
  });
  WriteFileAtomically(folder / kIndex, ToText(entries));
  return entries;
}

std::vector<HouseEntry> ReadHouseIndex(const std::filesystem::path& index) {
  const JsonNode root =
      JsonNode::Parse(ReadTextFile(index), index, "write it again with bulletnav scenes generate");
  const JsonNode houses = root["houses"];
  std::vector<HouseEntry> entries;
  for (std::size_t i = 0; i < houses.size(1); ++i) {
    const JsonNode house = houses[i];
    entries.push_back({house["file"].ToString(), house["split"].ToEnum<Split>(),
                       house["seed"].ToUint(), static_cast<int>(house["rooms"].ToUint()),
                       static_cast<double>(house["area_m2"].ToPositive())});
  }
  return entries;
}

}  // namespace bulletnav::sim
