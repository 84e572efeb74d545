// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "benchmark/perf/bench_figure.h"
#include "benchmark/perf/simulator_figures.h"

namespace bulletnav::bench {

/// Frames a second of training a policy by PPO on one scene, 32 lanes, with all processors: the
/// simulator alone at the policy's input (averaged, drawn directly, and with a metric map),
/// inference, the update by two epochs, and the whole. `tell` is called with each as it is ready.
/// Throws sim::Error if no episodes can be drawn.
void MeasureTraining(const BenchScene& scene, const std::function<void(const BenchFigure&)>& tell);

}  // namespace bulletnav::bench
