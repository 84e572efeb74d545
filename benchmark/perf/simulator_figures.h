// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "benchmark/perf/bench_figure.h"
#include "sim/scene/import.h"

namespace bulletnav::bench {

/// What to measure on.
struct BenchScene {
  std::filesystem::path file;
  sim::ImportOptions import;
};

/// The simulator's figures on one scene and on the same scene cut into a million triangles; `tell`
/// is called with each as it is ready. `program`: the executable to start for start-up time and
/// memory.
void MeasureSimulator(const BenchScene& scene, const std::filesystem::path& program,
                      const std::function<void(const BenchFigure&)>& tell);

}  // namespace bulletnav::bench
