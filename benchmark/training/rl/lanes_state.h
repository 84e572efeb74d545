// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "agent/models/safetensors.h"
#include "benchmark/training/rl/rollout.h"

namespace bulletnav::bench {

/// Where a task's lanes and their actor are, into a checkpoint and back. Throws FileError if
/// something is missing or of another shape.
void AppendLanes(const PolicyTask& task, const Actor& actor, agent::TensorFile* content);
void SetLanes(const agent::TensorFile& content, const std::filesystem::path& file, PolicyTask* task,
              Actor* actor);

}  // namespace bulletnav::bench
