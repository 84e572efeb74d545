// SPDX-License-Identifier: MIT
// The commands that are in bulletnav-learning.so, and what others take from it; see learning.h.
#include "benchmark/cli/commands.h"
#include "benchmark/cli/program.h"
#include "benchmark/perf/train_figures.h"

extern "C" int BulletnavRunLearningCommand(int argc, char** argv) {
  return bulletnav::bench::RunProgram(argc, argv, [](CLI::App* program) {
    bulletnav::bench::AddTrainCommand(program);
    bulletnav::bench::AddEvaluatePerceptionCommand(program);
    bulletnav::bench::AddEvaluatePolicyCommand(program);
    bulletnav::bench::AddQuantiseCommand(program);
    bulletnav::bench::AddStitchCommand(program);
  });
}

extern "C" void BulletnavMeasureTraining(
    const bulletnav::bench::BenchScene* scene,
    const std::function<void(const bulletnav::bench::BenchFigure&)>* tell) {
  bulletnav::bench::MeasureTraining(*scene, *tell);
}
