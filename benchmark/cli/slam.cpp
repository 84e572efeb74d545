// SPDX-License-Identifier: MIT
#include "benchmark/cli/slam.h"

#include "benchmark/cli/library.h"

namespace bulletnav::bench {
namespace {

constexpr ProgramLibrary kLibrary = {"bulletnav-slam.so", "SLAM", "BULLETNAV_SLAM", "slam",
                                     RTLD_LOCAL};

}  // namespace

int RunSlamCommand(int argc, char** argv) {
  using Run = int(int, char**);
  return FindFunction<Run>(kLibrary, OpenLibrary(kLibrary), "BulletnavRunSlamCommand")(argc, argv);
}

}  // namespace bulletnav::bench
