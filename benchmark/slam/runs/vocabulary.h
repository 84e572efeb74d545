// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// Grows a vocabulary from drives through a config's training houses, which are there; the workers
/// share the drives. Expects: a config with `vocabulary` (checked).
std::shared_ptr<const agent::Vocabulary> GrowVocabulary(const SlamConfig& config, int workers);

}  // namespace bulletnav::bench
