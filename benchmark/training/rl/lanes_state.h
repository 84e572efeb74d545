// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "agent/models/safetensors.h"
#include "benchmark/training/core/peers.h"
#include "benchmark/training/rl/rollout.h"

namespace bulletnav::bench {

/// A process's lanes and who plays them. `peers` (null: alone) have as many each.
struct LanesRef {
  PolicyTask* task = nullptr;
  Actor* actor = nullptr;
  Peers* peers = nullptr;
};

/// Where the lanes of all processes are, into a checkpoint, for each process to call, and back: as
/// many lanes may then be shared by another number of processes. Throws FileError if something is
/// missing or of another shape.
void AppendLanes(const LanesRef& lanes, agent::TensorFile* content);
void SetLanes(const agent::TensorFile& content, const std::filesystem::path& file,
              const LanesRef& lanes);

}  // namespace bulletnav::bench
