// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "sim/scene/import.h"

namespace bulletnav::bench {

/// Figures of a process that loads a scene and looks around once.
struct FirstObservation {
  double seconds = 0.0;           // from the process's start to the observation
  double memory_mb = 0.0;         // resident then
  double second_worker_mb = 0.0;  // what a second simulator on the same world adds
};

/// Starts `program` with the hidden command `first-observation` and measures it.
/// Throws Error if it fails.
FirstObservation MeasureFirstObservation(const std::filesystem::path& program,
                                         const std::filesystem::path& scene,
                                         const sim::ImportOptions& import);

/// What that command does, in this process: prints memory_mb and second_worker_mb.
void RunFirstObservation(const std::filesystem::path& scene, const sim::ImportOptions& import);

}  // namespace bulletnav::bench
