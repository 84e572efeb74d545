// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/episodes/episode.h"

namespace bulletnav::bench {

/// One of the shares that a run is split into, to be played by different processes or machines.
struct Shard {
  int number = 1;  // 1 to `of`
  int of = 1;

  bool operator==(const Shard&) const = default;
};

/// Of "2/8". Throws sim::Error unless 1 <= 2 <= 8.
Shard ParseShard(const std::string& text);

/// The share of this task of a Slurm array: tasks are counted from the lowest id, in the array's
/// step. None where SLURM_ARRAY_TASK_ID or SLURM_ARRAY_TASK_COUNT is not set. Throws sim::Error for
/// ids that are no such row, as --array=1,3,7. `variable`: as std::getenv.
std::optional<Shard> ShardOfArray(const std::function<const char*(const char*)>& variable);

/// DIR/shards/2-of-8.
std::filesystem::path ShardFolder(const std::filesystem::path& run_folder, const Shard& shard);
/// Those that are in a folder of results, in order; empty if it holds none.
std::vector<Shard> ShardsIn(const std::filesystem::path& run_folder);

/// The episodes of one share: a run of neighbours from the list sorted by scene, the scenes as they
/// first appear. All shares together load each scene once and at most `of` - 1 scenes once more,
/// the least there can be for shares whose sizes differ by one episode at most. In a scene the
/// kinds (easy, medium, hard, sequences) are mixed evenly, so that a scene that is cut gives each
/// of its parts the same mixture. Deterministic; every episode is in exactly one share.
std::vector<Episode> ShareOf(const std::vector<Episode>& episodes, const Shard& shard);

}  // namespace bulletnav::bench
