// SPDX-License-Identifier: MIT
#include "benchmark/runs/shard.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>
#include <system_error>
#include <tuple>

#include <fmt/core.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kMostShards = 100'000;
constexpr const char* kShardsFolder = "shards";

std::optional<int> WholeNumber(std::string_view text) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || number < 0) return std::nullopt;
  return number;
}

/// Of "2/8" or "2-of-8".
std::optional<Shard> Split(std::string_view text, std::string_view between) {
  const std::size_t at = text.find(between);
  if (at == std::string_view::npos) return std::nullopt;
  const auto number = WholeNumber(text.substr(0, at));
  const auto of = WholeNumber(text.substr(at + between.size()));
  if (!number || !of || *number < 1 || *number > *of || *of > kMostShards) return std::nullopt;
  return Shard{*number, *of};
}

/// By scene, then evenly mixed kinds.
struct Place {
  std::size_t scene = 0;
  double part = 0.0;  // of the scene's episodes of this kind that come before
  std::size_t episode = 0;

  bool operator<(const Place& other) const {
    return std::tie(scene, part, episode) < std::tie(other.scene, other.part, other.episode);
  }
};

std::vector<Place> PlacesOf(const std::vector<Episode>& episodes) {
  std::map<std::string, std::size_t> scenes;
  using Kind = std::pair<std::size_t, int>;  // of one scene
  std::vector<Kind> kinds;
  kinds.reserve(episodes.size());
  std::map<Kind, int> counts;
  for (const Episode& episode : episodes) {
    const std::size_t scene = scenes.try_emplace(episode.scene, scenes.size()).first->second;
    kinds.emplace_back(scene, episode.difficulty ? static_cast<int>(*episode.difficulty) : -1);
    ++counts[kinds.back()];
  }
  std::vector<Place> places;
  places.reserve(episodes.size());
  std::map<Kind, int> before;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const double middle = before[kinds[i]]++ + 0.5;
    places.push_back({kinds[i].first, middle / counts[kinds[i]], i});
  }
  return places;
}

}  // namespace

Shard ParseShard(const std::string& text) {
  const auto shard = Split(text, "/");
  if (shard) return *shard;
  throw sim::Error(fmt::format(
      "'{}' is no shard; give I/N with I from 1 to N, N at most {}, as 1/8", text, kMostShards));
}

std::optional<Shard> ShardOfArray(const std::function<const char*(const char*)>& variable) {
  const auto number = [&](const char* name) -> std::optional<int> {
    const char* text = variable(name);
    if (text == nullptr) return std::nullopt;
    const std::optional<int> whole = WholeNumber(text);
    if (whole) return whole;
    throw sim::Error(
        fmt::format("{} is '{}', which is no whole number; give --shard I/N, or take "
                    "the variable away",
                    name, text));
  };
  const auto id = number("SLURM_ARRAY_TASK_ID");
  const auto count = number("SLURM_ARRAY_TASK_COUNT");
  if (!id || !count) return std::nullopt;
  const int past = *id - number("SLURM_ARRAY_TASK_MIN").value_or(1);
  const int step = std::max(1, number("SLURM_ARRAY_TASK_STEP").value_or(1));
  const Shard shard = {past / step + 1, *count};
  if (past >= 0 && past % step == 0 && shard.number <= shard.of) return shard;
  throw sim::Error(
      fmt::format("SLURM_ARRAY_TASK_ID {} is none of {} ids in a row; make the array as "
                  "--array=1-{}, or give --shard I/N",
                  *id, *count, *count));
}

fs::path ShardFolder(const fs::path& run_folder, const Shard& shard) {
  return run_folder / kShardsFolder / fmt::format("{}-of-{}", shard.number, shard.of);
}

std::vector<Shard> ShardsIn(const fs::path& run_folder) {
  std::vector<Shard> shards;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(run_folder / kShardsFolder, none)) {
    const auto shard = Split(entry.path().filename().string(), "-of-");
    if (shard && entry.is_directory()) shards.push_back(*shard);
  }
  std::sort(shards.begin(), shards.end(), [](const Shard& a, const Shard& b) {
    return std::tie(a.of, a.number) < std::tie(b.of, b.number);
  });
  return shards;
}

std::vector<Episode> ShareOf(const std::vector<Episode>& episodes, const Shard& shard) {
  std::vector<Place> places = PlacesOf(episodes);
  std::sort(places.begin(), places.end());
  const auto begin_of = [&](int number) {
    return places.size() * static_cast<std::size_t>(number - 1) /
           static_cast<std::size_t>(shard.of);
  };
  std::vector<Episode> share;
  share.reserve(begin_of(shard.number + 1) - begin_of(shard.number));
  for (std::size_t i = begin_of(shard.number); i < begin_of(shard.number + 1); ++i) {
    share.push_back(episodes[places[i].episode]);
  }
  return share;
}

}  // namespace bulletnav::bench
