// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <span>

#include "benchmark/runs/run_worker.h"

namespace bulletnav::bench {

/// Stage "play": plays jobs of a plan, one after the other in each of `workers` threads (< 1: one a
/// processor). `finish` takes each finished episode, from any thread. Returns when all are done.
/// Throws what ended a worker, such as a scene that cannot be loaded or what `finish` throws.
void PlayJobs(const RunPlan& plan, std::span<const RunJob> jobs, int workers, SceneCache* scenes,
              const TakeEpisode& finish);

}  // namespace bulletnav::bench
