// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "benchmark/perf/bench_figure.h"

namespace bulletnav::bench {

/// What the shipped model of the setting rgbd takes: to encode a panorama, by itself and with seven
/// others, and to compare a goal with one place and with 64 at once. Throws sim::FileError if the
/// weights cannot be used.
void MeasureNetworks(const std::function<void(const BenchFigure&)>& tell);

}  // namespace bulletnav::bench
