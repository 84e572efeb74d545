// SPDX-License-Identifier: MIT
#include "benchmark/runs/shard_record.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "benchmark/base/program_version.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecordFile = "shard.yaml";

std::string EpisodesText(const std::optional<int>& episodes) {
  return episodes ? fmt::format("the first {}", *episodes) : "all";
}

}  // namespace

std::string RendererName(sim::Backend backend) {
  // Which backend it is to be is only known when a scene is made for it: a triangle will do.
  sim::SceneMesh triangle;
  triangle.positions = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}};
  triangle.uvs.resize(triangle.positions.size(), Eigen::Vector2f::Zero());
  triangle.colors.resize(triangle.positions.size(), sim::kWhite);
  triangle.triangles = {{0, 1, 2}};
  triangle.triangle_materials = {0};
  triangle.materials.emplace_back();
  const auto scene = sim::MakeRenderScene(triangle, backend);
  const std::string name(sim::NameOf(scene->backend()));
  return scene->backend() == sim::Backend::kEmbree ? name : name + ", " + scene->description();
}

ShardRecord MakeShardRecord(const Shard& shard, std::optional<int> episodes, sim::Backend backend,
                            std::string processor) {
  return {shard.number,         shard.of, episodes, ProgramVersion(), std::move(processor),
          RendererName(backend)};
}

ShardRecord ReadShardRecord(const fs::path& shard_folder) {
  return sim::LoadYaml<ShardRecord>(shard_folder / kRecordFile);
}

std::string DifferenceOf(const ShardRecord& a, const ShardRecord& b) {
  const auto other = [](const std::string& what, const std::string& here,
                        const std::string& there) {
    return fmt::format("of {} ({}, not {})", what, here, there);
  };
  if (a.of != b.of) return other("another split", std::to_string(b.of), std::to_string(a.of));
  if (a.episodes != b.episodes) {
    return other("other episodes", EpisodesText(b.episodes), EpisodesText(a.episodes));
  }
  if (a.program != b.program) return other("another program", b.program, a.program);
  if (a.processor != b.processor) {
    return other("another kind of processor, on which networks in floats differ", b.processor,
                 a.processor);
  }
  if (a.renderer != b.renderer) {
    return other("another renderer, whose pictures differ", b.renderer, a.renderer);
  }
  return "";
}

void RequireSplit(const fs::path& run_folder, const std::optional<Shard>& shard) {
  const std::vector<Shard> shards = ShardsIn(run_folder);
  if (shards.empty()) return;
  if (!shard) {
    if (fs::exists(run_folder / "episodes.jsonl")) return;
    throw sim::FileError(
        run_folder, "",
        fmt::format("holds shards of {0}; play one with --shard I/{0}, join them with "
                    "./bulletnav merge {1}, or choose another --out",
                    shards.front().of, run_folder.string()));
  }
  const auto other = std::find_if(shards.begin(), shards.end(), [&](const Shard& there) {
    return there.of != shard->of;
  });
  if (other == shards.end()) return;
  throw sim::FileError(
      run_folder, "",
      fmt::format("is split into {0} shards, not {1}; give --shard I/{0}, or choose another --out",
                  other->of, shard->of));
}

void BeginShard(const fs::path& shard_folder, const ShardRecord& record) {
  const fs::path file = shard_folder / kRecordFile;
  if (!fs::exists(file)) {
    sim::WriteFileAtomically(file, sim::ToYaml(record));
    return;
  }
  const std::string difference = DifferenceOf(record, ReadShardRecord(shard_folder));
  if (difference.empty()) return;
  throw sim::FileError(shard_folder, "",
                       "was begun as a shard " + difference +
                           "; delete this folder to play the shard again, or choose another --out");
}

}  // namespace bulletnav::bench
