// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::bench {

/// Runs a command line whose command is "slam" and returns the program's exit status. What works
/// with Ceres is in a library beside the program, bulletnav-slam.so, whose names stay its own:
/// Ceres brings a second BLAS, of which libtorch must not see anything.
/// Throws sim::Error if the program was built without it.
int RunSlamCommand(int argc, char** argv);

}  // namespace bulletnav::bench
