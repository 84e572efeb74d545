// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "benchmark/runs/runner.h"

namespace bulletnav::bench {

/// Joins the shards in DIR/shards into DIR: config.yaml, versions.txt, episodes.jsonl and
/// trajectories are then those that one process would have written there, byte for byte. The shards
/// stay. May be repeated, and killed at any moment: episodes.jsonl comes last, at once. Needs the
/// file of episodes and the weights, not the scenes.
/// Throws sim::Error, with a remedy, that names shards and episodes that are missing, and the shard
/// that is of another config, of other weights, episodes, scenes, program or renderer, or, with
/// learned agents, of another kind of processor than the first.
RunOutcome MergeShards(const std::filesystem::path& folder);

}  // namespace bulletnav::bench
