// SPDX-License-Identifier: MIT
#include "sim/house/unfinished_houses.h"

#include <algorithm>
#include <system_error>

#include <nlohmann/json.hpp>

#include "sim/base/files.h"
#include "sim/config/json_node.h"

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;

fs::path FileIn(const fs::path& folder) {
  return folder / "unfinished.json";
}

bool IsOf(const fs::path& file, const std::string& made_by, std::uint64_t first_seed) {
  const std::string remedy = "remove it, and the houses are made from the first one on";
  const auto document = ParseJson<FloatJson>(ReadTextFile(file), file, 1, remedy);
  const JsonNode root(document, file, "", remedy);
  return root.At("made_by").Text() == made_by && root.At("first_seed").Whole() == first_seed;
}

}  // namespace

UnfinishedHouses::UnfinishedHouses(fs::path folder, std::string made_by, std::uint64_t first_seed)
    : folder_(std::move(folder)), made_by_(std::move(made_by)), first_seed_(first_seed) {
  const fs::path file = FileIn(folder_);
  if (made_by_.empty() || !fs::exists(file) || !IsOf(file, made_by_, first_seed_)) return;
  houses_ = ReadHouseIndex(file);
}

void UnfinishedHouses::Begin() const {
  if (houses_.empty()) Finish();
}

bool UnfinishedHouses::Find(HouseEntry* house) const {
  const auto found = std::find_if(houses_.begin(), houses_.end(), [&](const HouseEntry& other) {
    return other.file == house->file && other.seed == house->seed;
  });
  if (found == houses_.end()) return false;
  const fs::path glb = folder_ / house->file;
  if (!fs::exists(glb) || !fs::exists(fs::path(glb).replace_extension(".json"))) return false;
  house->rooms = found->rooms;
  house->area_m2 = found->area_m2;
  return true;
}

void UnfinishedHouses::Add(const HouseEntry& house) {
  if (made_by_.empty()) return;
  const std::lock_guard lock(mutex_);
  houses_.push_back(house);
  const nlohmann::ordered_json text = {
      {"made_by", made_by_}, {"first_seed", first_seed_}, {"houses", ToJson(houses_)}};
  WriteFileAtomically(FileIn(folder_), text.dump(1) + "\n");
}

void UnfinishedHouses::Finish() const {
  std::error_code unwritable;  // where houses cannot be written either
  fs::remove(FileIn(folder_), unwritable);
}

}  // namespace bulletnav::sim
