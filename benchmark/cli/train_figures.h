// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "benchmark/perf/bench_figure.h"
#include "benchmark/perf/simulator_figures.h"

namespace bulletnav::bench {

/// Frames a second of one thread that simulates maps for exploration policies, without their
/// network: steps of a body towards goals at random in a scene, and what they are shown.
void MeasureMapSimulator(const BenchScene& scene,
                         const std::function<void(const BenchFigure&)>& tell);

}  // namespace bulletnav::bench
