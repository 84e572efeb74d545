// SPDX-License-Identifier: MIT
#include "benchmark/cli/slam.h"

#include "benchmark/cli/library.h"
#include "benchmark/cli/open_blas.h"

namespace bulletnav::bench {
namespace {

constexpr ProgramLibrary kLibrary = {"bulletnav-slam.so", "SLAM", "BULLETNAV_SLAM", "slam",
                                     RTLD_LOCAL};

}  // namespace

int RunSlamCommand(int argc, char** argv) {
  using Run = int(int, char**);
  SetUpOpenBlas(BlasKernels::kCommon);
  return FindFunction<Run>(kLibrary, OpenLibrary(kLibrary), "BulletnavRunSlamCommand")(argc, argv);
}

}  // namespace bulletnav::bench
