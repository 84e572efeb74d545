// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <vector>

#include "benchmark/training/supervised/data_config.h"
#include "benchmark/training/supervised/dataset.h"

namespace bulletnav::bench {

/// Draws the labels of a scene's first points for people to check. Of each point one picture: its
/// panorama with the twelve directions, explorable ones green; below it the scene from above with
/// the farthest points coloured by their score to one goal, the other points small, those of the
/// same node filled; beside it the goal's panorama and the map of obstacles around the point.
/// Returns the files <scene>-<point>.png in `folder`, which is made. Throws sim::FileError.
std::vector<std::filesystem::path> DrawLabels(const LabelledScene& scene, const DataConfig& config,
                                              int count, const std::filesystem::path& folder);

}  // namespace bulletnav::bench
