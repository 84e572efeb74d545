// SPDX-License-Identifier: MIT
#include "benchmark/runs/merge_shards.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "benchmark/base/file_hash.h"
#include "benchmark/base/first_difference.h"
#include "benchmark/episodes/episode_file.h"
#include "benchmark/play/belief_log.h"
#include "benchmark/play/trajectory.h"
#include "benchmark/runs/result_store.h"
#include "benchmark/runs/shard_record.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using sim::FileError;

constexpr std::size_t kNamed = 3;  // of those that are missing

/// One shard as it is on the disk.
struct Part {
  fs::path folder;
  ShardRecord record;
  std::string config;  // YAML text
  ResultLines lines;
};

std::string FirstOf(std::vector<std::string> names, const char* between) {
  const std::size_t more = names.size() - std::min(names.size(), kNamed);
  names.resize(names.size() - more);
  return fmt::format("{}{}", fmt::join(names, between),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

void RequireComplete(const fs::path& folder, const std::vector<Shard>& shards) {
  if (shards.empty()) {
    throw FileError(folder, "",
                    "holds no shards; play them with ./bulletnav run CONFIG --shard I/N --out " +
                        folder.string());
  }
  const int of = shards.front().of;
  if (shards.back().of != of) {
    throw FileError(ShardFolder(folder, shards.back()), "",
                    fmt::format("is of another split than {}; delete those of one split",
                                ShardFolder(folder, shards.front()).string()));
  }
  std::vector<std::string> missing;
  for (int number = 1; number <= of; ++number) {
    if (std::find(shards.begin(), shards.end(), Shard{number, of}) != shards.end()) continue;
    missing.push_back(fmt::format("{}/{}", number, of));
  }
  if (missing.empty()) return;
  throw FileError(folder, "",
                  fmt::format("these shards are missing: {}; play them, as with ./bulletnav run "
                              "CONFIG --shard {} --out {}",
                              FirstOf(missing, ", "), missing.front(), folder.string()));
}

/// The folder of a shard is of no other: one that was copied would take another's place.
void RequireOwnRecord(const fs::path& place, const Shard& shard, const ShardRecord& record) {
  if (Shard{record.shard, record.of} == shard) return;
  throw FileError(place / "shard.yaml", "",
                  fmt::format("is of shard {}/{}; delete the folder and play shard {}/{}",
                              record.shard, record.of, shard.number, shard.of));
}

std::vector<Part> ReadParts(const fs::path& folder) {
  std::vector<Shard> shards = ShardsIn(folder);
  // Of one that was stopped before it began there may be the folder alone.
  std::erase_if(shards, [&](const Shard& shard) {
    return !fs::exists(ShardFolder(folder, shard) / "shard.yaml");
  });
  RequireComplete(folder, shards);
  std::vector<Part> parts;
  parts.reserve(shards.size());
  for (const Shard& shard : shards) {
    const fs::path place = ShardFolder(folder, shard);
    const ShardRecord record = ReadShardRecord(place);
    RequireOwnRecord(place, shard, record);
    parts.push_back(
        {place, record, sim::ReadTextFile(place / "config.yaml"), ReadResultLines(place)});
  }
  return parts;
}

using Hashes = std::map<std::string, std::string>;  // by file, or what stands for it

/// Which files differ, the first of them by name: ", as house_003.glb".
std::string FirstOther(const Hashes& here, const Hashes& there) {
  const auto differs = [](const Hashes& of) {
    return [&of](const auto& entry) {
      const auto found = of.find(entry.first);
      return found == of.end() || found->second != entry.second;
    };
  };
  auto other = std::find_if(here.begin(), here.end(), differs(there));
  if (other == here.end()) other = std::find_if(there.begin(), there.end(), differs(here));
  return ", as " + other->first;
}

/// "other weights than FOLDER, as nts_rgbd", of two shards whose configs differ.
std::string DifferenceOf(const Part& part, const Part& first) {
  const auto found = [](const Part& of) {
    return LoadSavedRunConfig(of.folder / "config.yaml").fingerprints.value_or(Fingerprints());
  };
  const Fingerprints here = found(part);
  const Fingerprints there = found(first);
  const std::string other = first.folder.string();
  if (here.scenes != there.scenes) {
    return "other scenes than " + other + FirstOther(here.scenes, there.scenes);
  }
  if (here.episodes != there.episodes) return "another file of episodes than " + other;
  if (here.weights != there.weights) {
    return "other weights than " + other + FirstOther(here.weights, there.weights);
  }
  return "another config than " + other + ": " + FirstDifference(first.config, part.config);
}

void RequireSameConfig(const Part& part, const Part& first) {
  if (part.config == first.config) return;
  throw FileError(part.folder, "",
                  fmt::format("is of {}; delete the folder of the wrong one and play it again",
                              DifferenceOf(part, first)));
}

void RequireAlike(const std::vector<Part>& parts) {
  const Part& first = parts.front();
  for (const Part& part : parts) {
    RequireSameConfig(part, first);
    const std::string difference = DifferenceOf(first.record, part.record);
    if (difference.empty()) continue;
    throw FileError(part.folder, "",
                    fmt::format("is {} than {}; delete the folder of the wrong one and play it "
                                "again as the others were",
                                difference, first.folder.string()));
  }
}

std::vector<Episode> ReadChosenEpisodes(const RunConfig& config, const ShardRecord& record) {
  const fs::path file = config.episodes.file;
  if (FileHash(file) != config.fingerprints.value().episodes) {
    throw FileError(file, "", "is not the file that the shards are of; bring that back");
  }
  return Choose(ReadEpisodes(file).episodes, {record.episodes, {}});
}

/// Throws unless the part holds the results of all episodes of its share and no others.
void RequireWhole(const Part& part, const ResolvedRun& run, const std::vector<Episode>& episodes) {
  const RunPlan plan = PlanRun(run, {ShareOf(episodes, {part.record.shard, part.record.of}), {}});
  std::set<ResultKey> expected;
  for (const RunJob& job : JobsOf(plan)) expected.insert(plan.KeyOf(job));
  for (const auto& [key, line] : part.lines) {
    if (expected.contains(key)) continue;
    const std::vector<std::string> gone = MissingAgents(run.agents);
    throw FileError(part.folder, "",
                    fmt::format("holds a result of agent {} in episode '{}' that is not of its "
                                "share; {}",
                                key.agent, key.episode,
                                gone.empty() ? "delete the folder and play the shard again"
                                             : "cannot run here: " + FirstOf(gone, "; ")));
  }
  std::vector<std::string> missing;
  for (const ResultKey& key : expected) {
    if (part.lines.contains(key)) continue;
    missing.push_back(
        fmt::format("{} ({}, {}, seed {})", key.episode, key.agent, key.condition, key.seed));
  }
  if (missing.empty()) return;
  throw FileError(part.folder, "",
                  fmt::format("lacks {} of {} results: {}; go on with the same command and --shard "
                              "{}/{}",
                              missing.size(), expected.size(), FirstOf(missing, ", "),
                              part.record.shard, part.record.of));
}

/// The same file under another name, or a copy where there cannot be one.
void Bring(const fs::path& from, const fs::path& to) {
  if (!fs::exists(from)) throw FileError(from, "", "is missing; play the shard again");
  if (fs::exists(to) && fs::equivalent(from, to)) return;
  sim::WriteFileAtomically(to, [&](const fs::path& temporary) {
    std::error_code no_link;
    fs::create_hard_link(from, temporary, no_link);
    if (no_link) fs::copy_file(from, temporary);
  });
}

void BringTrajectories(const Part& part, const fs::path& folder) {
  for (const auto& [key, line] : part.lines) {
    Bring(TrajectoryPath(part.folder, key), TrajectoryPath(folder, key));
  }
}

/// Of the shards that have logged them.
void BringBeliefs(const Part& part, const fs::path& folder) {
  for (const auto& [key, line] : part.lines) {
    const fs::path beliefs = BeliefPath(part.folder, key);
    if (fs::exists(beliefs)) Bring(beliefs, BeliefPath(folder, key));
  }
}

}  // namespace

RunOutcome MergeShards(const fs::path& folder) {
  const std::vector<Part> parts = ReadParts(folder);
  const RunConfig config = LoadRunConfig(parts.front().folder / "config.yaml");
  RequireAlike(parts);
  const ResolvedRun run = ResolveRun(config, false);
  const std::vector<Episode> episodes = ReadChosenEpisodes(config, parts.front().record);
  for (const Part& part : parts) RequireWhole(part, run, episodes);
  ResultStore store(folder, parts.front().config, [&](const std::string& saved) {
    return LacksOnlyWeights(saved, config);
  });
  ResultLines lines;
  for (const Part& part : parts) {
    if (config.trajectories) BringTrajectories(part, folder);
    BringBeliefs(part, folder);
    lines.insert(part.lines.begin(), part.lines.end());
  }
  sim::WriteFileAtomically(folder / "versions.txt", parts.front().record.program + "\n");
  store.Add(lines);
  return Summarise(PlanRun(run, {}), folder, store.results());
}

}  // namespace bulletnav::bench
