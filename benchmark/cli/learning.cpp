// SPDX-License-Identifier: MIT
#include "benchmark/cli/learning.h"

#include <cstdlib>

#include "benchmark/cli/library.h"

namespace bulletnav::bench {
namespace {

constexpr ProgramLibrary kLibrary = {"bulletnav-learning.so", "learning", "BULLETNAV_LEARNING",
                                     "train", RTLD_GLOBAL};

/// OpenBLAS reads these when it is loaded. Its threads only get in the way of ours. Debian 12's
/// takes processors that are newer than it for ones without AVX-512.
void SetUpOpenBlas() {
  constexpr int kKeep = 0;  // what the user has set
  ::setenv("OPENBLAS_NUM_THREADS", "1", kKeep);
#if defined(__x86_64__)
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq");
  if (has_avx512) ::setenv("OPENBLAS_CORETYPE", "SkylakeX", kKeep);
#endif
}

void* Library() {
  static void* const library = [] {
    SetUpOpenBlas();
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
