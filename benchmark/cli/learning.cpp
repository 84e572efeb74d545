// SPDX-License-Identifier: MIT
#include "benchmark/cli/learning.h"

#include "benchmark/cli/library.h"
#include "benchmark/cli/open_blas.h"

namespace bulletnav::bench {
namespace {

constexpr ProgramLibrary kLibrary = {"bulletnav-learning.so", "learning", "BULLETNAV_LEARNING",
                                     "train", RTLD_GLOBAL};

void* Library() {
  static void* const library = [] {
    SetUpOpenBlas(BlasKernels::kFastest);
    return OpenLibrary(kLibrary);
  }();
  return library;
}

}  // namespace

void LoadLearning() {
  Library();
}

int RunLearningCommand(int argc, char** argv) {
  using Run = int(int, char**);
  return FindFunction<Run>(kLibrary, Library(), "BulletnavRunLearningCommand")(argc, argv);
}

void MeasureTrainingThere(const BenchScene& scene,
                          const std::function<void(const BenchFigure&)>& tell) {
  using Measure = void(const BenchScene*, const std::function<void(const BenchFigure&)>*);
  FindFunction<Measure>(kLibrary, Library(), "BulletnavMeasureTraining")(&scene, &tell);
}

}  // namespace bulletnav::bench
