// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "benchmark/runs/shard.h"
#include "sim/render/renderer.h"

namespace bulletnav::bench {

/// Of results that are the same bits on every processor: no network acts in floats.
inline constexpr const char* kAnyProcessor = "any";

/// What a shard's results depend on besides its config.yaml: shard.yaml in its folder, written
/// before the first episode.
struct ShardRecord {
  int shard = 1;
  int of = 1;
  std::optional<int> episodes;  // only so many of the run were split
  std::string program;          // ProgramVersion
  std::string processor;        // ProcessorKind, or kAnyProcessor
  std::string renderer;         // RendererName

  template <class V>
  void Visit(V& v) {
    v.Required("shard", shard);
    v.Required("of", of);
    v("episodes", episodes);
    v.Required("program", program);
    v.Required("processor", processor);
    v.Required("renderer", renderer);
  }
};

/// What draws in this process: "embree", whose pictures are the same bits on every processor, or
/// "egl, " and its GL_RENDERER. Throws sim::RenderError if there is no such backend.
std::string RendererName(sim::Backend backend);

/// Of this process. `processor`: kAnyProcessor, or that of this process where it counts.
ShardRecord MakeShardRecord(const Shard& shard, std::optional<int> episodes, sim::Backend backend,
                            std::string processor);
/// Throws sim::FileError.
ShardRecord ReadShardRecord(const std::filesystem::path& shard_folder);

/// "of other episodes (the first 20, not all)" and the like, `b` being not as `a`: empty if both
/// can be parts of one run.
std::string DifferenceOf(const ShardRecord& a, const ShardRecord& b);

/// Throws sim::Error, with a remedy, if `run_folder` is split into another number of shards; or, if
/// `shard` is none, if it is split and nothing has been merged yet.
void RequireSplit(const std::filesystem::path& run_folder, const std::optional<Shard>& shard);

/// Writes the record of a shard that begins. Throws sim::FileError, with a remedy, if the folder
/// holds one that differs.
void BeginShard(const std::filesystem::path& shard_folder, const ShardRecord& record);

}  // namespace bulletnav::bench
