// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "benchmark/perf/bench_figure.h"
#include "benchmark/perf/simulator_figures.h"

namespace bulletnav::bench {

/// Takes in what works with libtorch: the networks and the trainers, which make themselves known to
/// the program's registries. They are in a library beside the program, bulletnav-learning.so, since
/// loading torch takes a third of a second and 150 MB, which most commands have no use for. Does
/// nothing the second time. Throws sim::Error if the program was built without learning.
void LoadLearning();

/// Runs a command line whose command is in that library. Returns the program's exit status.
int RunLearningCommand(int argc, char** argv);

/// The figures of training, see benchmark/perf/train_figures.h. Throws what they throw, and
/// sim::Error if the program was built without learning.
void MeasureTrainingThere(const BenchScene& scene,
                          const std::function<void(const BenchFigure&)>& tell);

}  // namespace bulletnav::bench
