// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "benchmark/perf/bench_figure.h"
#include "benchmark/perf/simulator_figures.h"

namespace bulletnav::bench {

/// The figures of runs on one scene, with metric_map_fbe and its oracle: steps a second of the
/// whole run with one worker and with two, what the agent takes of a step, and what the runner
/// (bookkeeping, files) takes of the run, as the difference to the same episodes played in a plain
/// loop. `tell` is called with each as it is ready. Throws sim::Error if no episodes can be drawn.
void MeasureRuns(const BenchScene& scene, const std::function<void(const BenchFigure&)>& tell);

/// Steps a second of a run of `nts` with the shipped weights, rgbd, one worker.
void MeasureLearnedRuns(const BenchScene& scene,
                        const std::function<void(const BenchFigure&)>& tell);

}  // namespace bulletnav::bench
